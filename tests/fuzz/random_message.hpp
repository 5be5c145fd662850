// Messages of the right form with values as the input wants them: deeper into the handlers than bytes that happen to
// parse.
#pragma once

#include <fuzzer/FuzzedDataProvider.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <array>
#include <string>

namespace cnclab {

inline void fill(google::protobuf::Message& message, FuzzedDataProvider& input, int depth = 0);

namespace random_message {

using google::protobuf::FieldDescriptor;

/// Names that exist, names that do not, and anything.
inline std::string text(FuzzedDataProvider& input) {
  static constexpr std::array<const char*, 9> kKnown{
      "eva", "udo", "lehrer", "gast", "geheim123", "student", "observer", "P0001N001G01X+1000F1000%", "2026-01-31"};
  if (input.ConsumeProbability<float>() < 0.7F) return input.PickValueInArray(kKnown);
  return input.ConsumeRandomLengthString(40);
}

/// Mostly small: stations, programs, versions.
template <class Number>
Number number(FuzzedDataProvider& input) {
  return input.ConsumeBool() ? input.ConsumeIntegralInRange<Number>(0, 20) : input.ConsumeIntegral<Number>();
}

inline void set(google::protobuf::Message& message, const FieldDescriptor* field, FuzzedDataProvider& input,
                int depth) {
  const auto* reflection = message.GetReflection();
  const bool is_list = field->is_repeated();
  const auto put = [&](auto set_one, auto add_one, auto value) {
    if (is_list)
      (reflection->*add_one)(&message, field, value);
    else
      (reflection->*set_one)(&message, field, value);
  };
  using R = google::protobuf::Reflection;
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return put(&R::SetInt32, &R::AddInt32, number<std::int32_t>(input));
    case FieldDescriptor::CPPTYPE_INT64:
      return put(&R::SetInt64, &R::AddInt64, number<std::int64_t>(input));
    case FieldDescriptor::CPPTYPE_UINT32:
      return put(&R::SetUInt32, &R::AddUInt32, number<std::uint32_t>(input));
    case FieldDescriptor::CPPTYPE_UINT64:
      return put(&R::SetUInt64, &R::AddUInt64, number<std::uint64_t>(input));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return put(&R::SetDouble, &R::AddDouble, input.ConsumeFloatingPoint<double>());
    case FieldDescriptor::CPPTYPE_FLOAT:
      return put(&R::SetFloat, &R::AddFloat, input.ConsumeFloatingPoint<float>());
    case FieldDescriptor::CPPTYPE_BOOL:
      return put(&R::SetBool, &R::AddBool, input.ConsumeBool());
    case FieldDescriptor::CPPTYPE_ENUM:
      return put(&R::SetEnumValue, &R::AddEnumValue, number<std::int32_t>(input));
    case FieldDescriptor::CPPTYPE_STRING:
      return put(&R::SetString, &R::AddString, text(input));
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return fill(is_list ? *reflection->AddMessage(&message, field) : *reflection->MutableMessage(&message, field),
                  input, depth + 1);
  }
}

}  // namespace random_message

/// One field of each oneof, the others by chance; lists get up to two entries.
inline void fill(google::protobuf::Message& message, FuzzedDataProvider& input, int depth) {
  constexpr int kDeepest = 6;
  if (depth > kDeepest) return;
  const auto* descriptor = message.GetDescriptor();
  for (int i = 0; i < descriptor->oneof_decl_count(); ++i) {
    const auto* oneof = descriptor->oneof_decl(i);
    random_message::set(message, oneof->field(input.ConsumeIntegralInRange(0, oneof->field_count() - 1)), input, depth);
  }
  for (int i = 0; i < descriptor->field_count(); ++i) {
    const auto* field = descriptor->field(i);
    if (field->containing_oneof() != nullptr) continue;
    const int times = input.ConsumeIntegralInRange(0, field->is_repeated() ? 2 : 1);
    for (int time = 0; time < times; ++time) random_message::set(message, field, input, depth);
  }
}

}  // namespace cnclab
