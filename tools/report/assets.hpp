#pragma once

/// Files that are compiled in (CMakeLists.txt), so that a report needs nothing but itself.
namespace evbal {

/// The page.
extern const char* const page_html;
/// Its style.
extern const char* const page_css;
extern const char* const page_js;  ///< all scripts of page/, one after the other
/// D3, with which it draws.
extern const char* const d3_js;
extern const char* const figures_js;     ///< those scripts that draw a study's figures, which are part of page_js too
extern const char* const draw_files_js;  ///< what Node.js runs to draw these figures into files

}  // namespace evbal
