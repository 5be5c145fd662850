// What scripts read: JSON in one line with the names of the interface description (INS-005).
#include "instructor/item_text.hpp"

#include <gtest/gtest.h>

#include "cnclab/v1/instructor.pb.h"

namespace cnclab::instructor {
namespace {

TEST(ItemText, INS_005_a_student_is_one_line_with_every_field) {
  v1::InstructorItem item;
  item.mutable_student()->set_name("anna");
  item.mutable_student()->set_role("student");
  item.mutable_student()->set_memory_free(16221);
  EXPECT_EQ(text_of(item),
            R"({"name":"anna","role":"student","language":"","model":"","station":0,"programs":0,"memory_free":16221,)"
            R"("last_seen":"","archived":false})"
            "\n");
}

TEST(ItemText, INS_005_status_has_the_names_and_numbers_of_the_description) {
  v1::InstructorItem item;
  auto& status = *item.mutable_status();
  status.set_selected(7);
  status.set_lease(12);
  status.mutable_machine()->set_state("standstill");
  status.mutable_machine()->set_x(85.005);
  status.mutable_ticks()->set_longest_ms(0.25);
  status.add_stations()->set_station(7);
  const std::string text = text_of(item);
  EXPECT_EQ(
      text.find(R"({"selected":7,"offered":0,"lease":12,"halted_by":"","machine":{"state":"standstill",)"
                R"("referenced":false,"x":85.005,"y":0,"z":0,"u":0,"feed":0,"spindle":0,"damaged_data":[]},)"
                R"("ticks":{"late":0,"longest_ms":0.25,"stalls":0,"very_late":0},"stations":[{"station":7,"user":"")"),
      0U)
      << text;
  EXPECT_EQ(text.find('\n'), text.size() - 1);
}

TEST(ItemText, INS_003_a_program_is_its_tape_text) {
  v1::InstructorItem item;
  item.mutable_program_text()->set_text("P0001\nN001G00X+1000");
  EXPECT_EQ(text_of(item), "P0001\nN001G00X+1000\n");
}

TEST(ItemText, INS_002_a_watched_screen_comes_as_headless_prints_it) {
  v1::InstructorItem item;
  item.mutable_screen()->add_rows("CNC 3300");
  item.mutable_screen()->add_rows("        ");
  EXPECT_EQ(text_of(item), "|CNC 3300|\n|        |\nend\n");
}

TEST(ItemText, an_item_of_a_newer_server_is_an_empty_object) { EXPECT_EQ(text_of({}), "{}\n"); }

}  // namespace
}  // namespace cnclab::instructor
