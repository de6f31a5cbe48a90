#include "common/yaml_writer.hpp"

#include "common/yaml.hpp"

#include <yaml-cpp/yaml.h>

#include <cassert>

namespace evbal {

struct YamlWriter::Emitter {
  YAML::Emitter out;
};

YamlWriter::YamlWriter() : emitter_(std::make_unique<Emitter>()) {
  emitter_->out << YAML::BeginMap;
}

YamlWriter::~YamlWriter() = default;

YamlWriter& YamlWriter::key(const std::string& name) {
  emitter_->out << YAML::Key << name << YAML::Value;
  return *this;
}

YamlWriter& YamlWriter::text(const std::string& value) {
  emitter_->out << YAML::DoubleQuoted << value;
  return *this;
}

YamlWriter& YamlWriter::word(const std::string& value) {
  emitter_->out << value;
  return *this;
}

YamlWriter& YamlWriter::value(const YamlValue& value) {
  emitter_->out << *value.node_;
  return *this;
}

YamlWriter& YamlWriter::begin_map(Layout layout) {
  emitter_->out << (layout == Layout::lines ? YAML::Block : YAML::Flow) << YAML::BeginMap;
  return *this;
}

YamlWriter& YamlWriter::end_map() {
  emitter_->out << YAML::EndMap;
  return *this;
}

YamlWriter& YamlWriter::begin_list(Layout layout) {
  emitter_->out << (layout == Layout::lines ? YAML::Block : YAML::Flow) << YAML::BeginSeq;
  return *this;
}

YamlWriter& YamlWriter::end_list() {
  emitter_->out << YAML::EndSeq;
  return *this;
}

std::string YamlWriter::finish() {
  emitter_->out << YAML::EndMap;
  assert(emitter_->out.good());
  return std::string(emitter_->out.c_str()) + "\n";
}

}  // namespace evbal
