#include "agents/bus/grants.hpp"

#include "agents/bus/topics.hpp"

namespace evbal {
namespace {

std::string element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">\n";
}

std::string document(const std::string& content) {
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<dds>\n" + content + "</dds>\n";
}

std::string only(int domain) {
  return element("domains", element("id", std::to_string(domain)));
}

/// The topics of which `chosen` is true, if there are any.
template <class Chosen>
std::string topics_for(const std::string& purpose, Chosen chosen) {
  std::string names;
  for_each_topic([&](auto topic) {
    if (chosen(topic)) {
      names += element("topic", topic.name);
    }
  });
  return names.empty() ? "" : element(purpose, element("topics", names));
}

}  // namespace

std::string governance_of(int domain) {
  const std::string topics =
      element("topic_expression", "*") + element("enable_discovery_protection", "true") +
      element("enable_liveliness_protection", "false") + element("enable_read_access_control", "true") +
      element("enable_write_access_control", "true") + element("metadata_protection_kind", "ENCRYPT") +
      element("data_protection_kind", "NONE");  // the data are in what is encrypted already
  return document(element(
      "domain_access_rules",
      element("domain_rule", only(domain) + element("allow_unauthenticated_participants", "false") +
                                 element("enable_join_access_control", "true") +
                                 element("discovery_protection_kind", "ENCRYPT") +
                                 element("liveliness_protection_kind", "NONE") +  // the bus does without liveliness
                                 element("rtps_protection_kind", "NONE") +
                                 element("topic_access_rules", element("topic_rule", topics)))));
}

std::string grant_of(const Subject& subject, int participant, int domain) {
  const std::string writes = topics_for("publish", [&](auto topic) { return topic.has_say(participant); });
  const std::string reads = topics_for("subscribe", [&](auto topic) { return topic.listens(participant); });
  return document(
      element("permissions",
              "<grant name=\"" + subject.process + "\">\n" + element("subject_name", text_of(subject)) +
                  element("validity",
                          element("not_before", "2000-01-01T00:00:00") + element("not_after", "2100-01-01T00:00:00")) +
                  element("allow_rule", only(domain) + writes + reads) + element("default", "DENY") + "</grant>\n"));
}

}  // namespace evbal
