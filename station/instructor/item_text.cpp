// One object of an answer as the one-shot commands print it.
#include "instructor/item_text.hpp"

#include <google/protobuf/util/json_util.h>

#include "cnclab/v1/instructor.pb.h"

namespace cnclab::instructor {
namespace {

std::string json_of(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  options.always_print_primitive_fields = true;
  std::string json;
  const auto status = google::protobuf::util::MessageToJsonString(message, &json, options);
  return status.ok() ? json : "{}";
}

std::string screen_text(const v1::ScreenText& screen) {
  std::string text;
  for (const auto& row : screen.rows()) text += "|" + row + "|\n";
  return text + "end\n";
}

std::string ended(std::string text) {
  if (!text.ends_with('\n')) text += '\n';
  return text;
}

}  // namespace

std::string text_of(const v1::InstructorItem& item) {
  if (item.has_program_text()) return ended(item.program_text().text());
  if (item.has_screen()) return screen_text(item.screen());
  const auto* choice = v1::InstructorItem::descriptor()->FindOneofByName("what");
  const auto* field = item.GetReflection()->GetOneofFieldDescriptor(item, choice);
  if (field == nullptr) return "{}\n";
  return json_of(item.GetReflection()->GetMessage(item, field)) + "\n";
}

}  // namespace cnclab::instructor
