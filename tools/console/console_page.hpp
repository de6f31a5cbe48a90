#pragma once

#include <string>

namespace evbal {

/// The console's page, one file of HTML that needs nothing else.
std::string console_page();

}  // namespace evbal
