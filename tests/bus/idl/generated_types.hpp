#pragma once

// The types that Fast DDS's generator made of the IDL, whichever version of it: 4 (Debian 13) or 2 (Debian 12).

#if __has_include(<evbalPubSubTypes.hpp>)
#include <evbalPubSubTypes.hpp>
#include <fastdds/rtps/common/SerializedPayload.hpp>

namespace evbal::test {

using Payload = eprosima::fastdds::rtps::SerializedPayload_t;
constexpr auto plain_cdr = eprosima::fastdds::dds::DataRepresentationId::XCDR_DATA_REPRESENTATION;

template <class Type>
bool read(Type& type, Payload& payload, typename Type::type& message) {
  return type.deserialize(payload, &message);
}
template <class Type>
std::uint32_t size_of(Type& type, const typename Type::type& message) {
  return type.calculate_serialized_size(&message, plain_cdr);
}
template <class Type>
bool write(Type& type, const typename Type::type& message, Payload& payload) {
  return type.serialize(&message, payload, plain_cdr);
}

}  // namespace evbal::test
#else
#include <evbalPubSubTypes.h>
#include <fastdds/rtps/common/SerializedPayload.h>

namespace evbal::test {

using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

template <class Type>
bool read(Type& type, Payload& payload, typename Type::type& message) {
  return type.deserialize(&payload, &message);
}
template <class Type>
std::uint32_t size_of(Type& type, typename Type::type& message) {
  return type.getSerializedSizeProvider(&message)();
}
template <class Type>
bool write(Type& type, typename Type::type& message, Payload& payload) {
  return type.serialize(&message, &payload);
}

}  // namespace evbal::test
#endif
