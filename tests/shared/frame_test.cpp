// Frame headers: the length's limits (interfaces.md section 7), and framing of messages.
#include "shared/frame.hpp"

#include <cnclab/v1/session.pb.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace cnclab {
namespace {

using Header = std::array<std::uint8_t, kFrameHeader>;

TEST(Frame, LengthsAtTheirLimits) {
  EXPECT_EQ(body_length(Header{0, 0, 0, 0}).error(), FrameError::empty);
  EXPECT_EQ(body_length(Header{0, 0, 0, 1}), 1U);
  EXPECT_EQ(body_length(Header{0, 0, 1, 2}), 258U) << "big-endian";
  EXPECT_EQ(body_length(Header{0, 1, 0, 0}), 65'536U);
  EXPECT_EQ(body_length(Header{0, 1, 0, 1}).error(), FrameError::too_large);
  EXPECT_EQ(body_length(Header{0xFF, 0xFF, 0xFF, 0xFF}).error(), FrameError::too_large);
}

RC_GTEST_PROP(Frame, TheHeaderSaysHowLongTheBodyIs, ()) {
  v1::Bye message;
  message.set_exit_code(9);
  message.set_text(std::string(*rc::gen::inRange<std::size_t>(0, 60'000), 'x'));
  const std::string bytes = frame(message);
  Header header{};
  std::copy_n(bytes.begin(), kFrameHeader, header.begin());
  RC_ASSERT(body_length(header).value() == bytes.size() - kFrameHeader);
  v1::Bye back;
  RC_ASSERT(back.ParseFromString(bytes.substr(kFrameHeader)));
  RC_ASSERT(back.text() == message.text());
}

}  // namespace
}  // namespace cnclab
