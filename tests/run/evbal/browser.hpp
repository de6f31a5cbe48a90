#pragma once

#include "tests/folder.hpp"

#include <nlohmann/json_fwd.hpp>
#include <sys/types.h>

#include <string>

namespace evbal {

/// A headless Chromium, driven by its DevTools protocol over two pipes. It looks up no names.
class Browser {
 public:
  Browser();
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// Opens a page.
  void open(const std::string& address);

  /// What an expression of JavaScript in the page comes to, as JSON; of a promise what it is kept with. An exception is
  /// given as a text.
  std::string value_of(const std::string& expression);

  /// Waits until the expression is true, half a minute at most, and says whether it became so.
  bool comes_true(const std::string& expression);

 private:
  nlohmann::json call(const std::string& method, const nlohmann::json& params);
  std::string next_message();

  Folder folder_;
  int to_ = -1;
  int from_ = -1;
  pid_t id_ = 0;
  int calls_ = 0;
  std::string session_;
  std::string heard_;
};

}  // namespace evbal
