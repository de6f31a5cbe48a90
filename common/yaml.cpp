#include "common/yaml.hpp"

#include "common/plain_text.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

namespace evbal {
namespace {

/// Refuses bytes that YAML does not allow in a text, and that yaml-cpp takes as something else: 4 as the end.
void check_characters(const std::string& text, const std::string& name) {
  const auto refuse = [&](std::size_t at, const char* what) {
    if (at != std::string::npos) {
      const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
      throw bad_input(name, static_cast<int>(line), what);
    }
  };
  refuse(find_invalid_utf8(text), "is not UTF-8; write the file in UTF-8");
  refuse(find_control_character(text), "holds a control character; leave it out");
}

/// Finds the first thing in the second document of a text.
class SecondDocument : public YAML::EventHandler {
 public:
  YAML::Mark first = YAML::Mark::null_mark();  ///< thing in it that is not null

  void OnDocumentStart(const YAML::Mark&) override { ++documents_; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t, const std::string&) override { see(mark); }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    see(mark);
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    see(mark);
  }
  void OnMapEnd() override {}

 private:
  void see(const YAML::Mark& mark) { first = documents_ == 2 && first.is_null() ? mark : first; }

  int documents_ = 0;
};

/// Line of the first thing in the second of several documents, 0 if there is but one. YAML::LoadAll would read on for
/// ever where a comma follows what is in braces: it takes it for one document after the other.
int line_of_second(const std::string& text) {
  std::istringstream in(text);
  YAML::Parser parser(in);
  SecondDocument second;
  if (!parser.HandleNextDocument(second) || !parser.HandleNextDocument(second)) {
    return 0;
  }
  const auto last = std::max(1, static_cast<int>(std::count(text.begin(), text.end(), '\n')));
  return second.first.is_null() ? last : std::min(second.first.line + 1, last);
}

}  // namespace

/// What was read.
struct YamlValue::Source {
  std::string name;       ///< of the file, or an option
  bool has_lines = true;  ///< it is a file
};

YamlValue::YamlValue(std::shared_ptr<const YAML::Node> node, std::shared_ptr<const Source> source)
    : node_(std::move(node)), source_(std::move(source)) {}

YamlValue YamlValue::load(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) {
    throw bad_input(file.string(), 0, "cannot be read; give an existing YAML file");
  }
  std::ostringstream text;
  text << in.rdbuf();
  return parse(text.str(), file.string());
}

YamlValue YamlValue::parse(const std::string& text, const std::string& name) {
  return parse(text, Source{name});
}

YamlValue YamlValue::parse_option(const std::string& text, const std::string& option) {
  return parse(text, Source{.name = option, .has_lines = false});
}

YamlValue YamlValue::parse(const std::string& text, Source source) {
  const std::string name = source.name;
  const auto line = [&source](int number) { return source.has_lines ? number : 0; };
  try {
    check_characters(text, name);
    if (const int second = line_of_second(text); second > 0) {
      throw bad_input(
          name, line(second),
          "a second document begins after `---`, `...` or what is in braces; leave one document in the file");
    }
    const YAML::Node document = YAML::Load(text);
    if (document.IsNull()) {
      throw bad_input(name, line(1), source.has_lines ? "is empty; a YAML map is expected" : "is empty; give a value");
    }
    return {std::make_shared<YAML::Node>(document), std::make_shared<Source>(std::move(source))};
  } catch (const YAML::Exception& e) {
    throw bad_input(name, line(e.mark.line + 1), "not valid YAML: " + e.msg);
  }
}

bool YamlValue::is_map() const {
  return node_->IsMap();
}

bool YamlValue::is_list() const {
  return node_->IsSequence();
}

bool YamlValue::is_scalar() const {
  return node_->IsScalar();
}

int YamlValue::line() const {
  if (!source_->has_lines) {
    return 0;
  }
  if (node_->Mark().is_null() && !settings_.empty()) {  // a map that is there for its settings only
    return settings_.front().value.line();
  }
  return node_->Mark().line + 1;
}

const std::string& YamlValue::file() const {
  return source_->name;
}

Error YamlValue::error(const std::string& message) const {
  return bad_input(file(), line(), message);
}

std::vector<YamlValue> YamlValue::items() const {
  if (!is_list()) {
    throw error("expected a list");
  }
  std::vector<YamlValue> values;
  for (const auto& item : *node_) {
    values.push_back({std::make_shared<YAML::Node>(item), source_});
  }
  return values;
}

std::string YamlValue::dump() const {
  return YAML::Dump(*node_);
}

YamlValue YamlValue::with(const std::string& path, const YamlValue& value) const {
  YamlValue copy = *this;
  copy.settings_.push_back({path, value});
  return copy;
}

YamlMap::YamlMap(const YamlValue& value) : value_(value) {
  if (!value.is_map()) {
    throw value.error("expected a map of `key: value`");
  }
  for (const auto& entry : *value.node_) {
    const YamlValue key{std::make_shared<YAML::Node>(entry.first), value.source_};
    const std::string name = key.text();
    const YamlValue content{std::make_shared<YAML::Node>(entry.second), value.source_};
    if (!entries_.emplace(name, content).second) {
      throw key.error("key `" + name + "` is given twice");
    }
    key_places_.emplace(name, key);
    order_.push_back(name);
  }
  for (const auto& setting : value.settings_) {
    set(setting);
  }
}

void YamlMap::set(const YamlValue::Setting& setting) {
  const std::size_t dot = setting.path.find('.');
  const std::string key = setting.path.substr(0, dot);
  const auto found = entries_.find(key);
  YamlValue content = setting.value;
  if (dot != std::string::npos) {
    if (found != entries_.end() && !found->second.is_map()) {
      throw setting.value.error("`" + key + "` holds no keys, so none can be set in it");
    }
    const YamlValue empty{std::make_shared<YAML::Node>(YAML::NodeType::Map), setting.value.source_};
    content = (found == entries_.end() ? empty : found->second).with(setting.path.substr(dot + 1), setting.value);
  }
  if (found == entries_.end()) {
    order_.push_back(key);
    key_places_.emplace(key, setting.value);
  }
  entries_.insert_or_assign(key, content);
}

std::optional<YamlValue> YamlMap::find(const std::string& key) {
  known_.insert(key);
  const auto found = entries_.find(key);
  return found == entries_.end() ? std::nullopt : std::optional(found->second);
}

YamlValue YamlMap::require(const std::string& key) {
  auto value = find(key);
  if (!value) {
    throw value_.error("key `" + key + "` is missing");
  }
  return *value;
}

void YamlMap::finish() const {
  const std::vector<std::string> known(known_.begin(), known_.end());
  for (const auto& key : order_) {
    if (!known_.contains(key)) {
      throw key_places_.at(key).error("unknown key `" + key + "`" + did_you_mean(key, known) + "; known are " +
                                      listed(known));
    }
  }
}

}  // namespace evbal
