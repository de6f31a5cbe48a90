#pragma once

/// Files that are compiled in (CMakeLists.txt), so that a report needs nothing but itself.
namespace evbal {

extern const char* const page_html;
extern const char* const page_js;
extern const char* const chart_js;

}  // namespace evbal
