#pragma once

/// Files that are compiled in (CMakeLists.txt), so that a report needs nothing but itself.
namespace evbal {

extern const char* const page_html;
extern const char* const page_css;
extern const char* const page_js;  ///< all scripts of page/, one after the other
extern const char* const d3_js;

}  // namespace evbal
