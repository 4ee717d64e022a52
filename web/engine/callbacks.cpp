// The functions that leadscrew.h calls, for a page: each hands what it is given on to the page, which imports nothing else.

#include "leadscrew.h"

// NOLINTBEGIN(readability-identifier-naming)
extern "C" {
[[clang::import_module("page"), clang::import_name("diagnostic")]] void page_diagnostic(const leadscrew_error* error);
[[clang::import_module("page"), clang::import_name("block")]] void page_block(const leadscrew_block* block);
[[clang::import_module("page"), clang::import_name("tool")]] void page_tool(const leadscrew_tool* tool);
[[clang::import_module("page"), clang::import_name("surface")]] void page_surface(const leadscrew_surface* surface);
[[clang::import_module("page"), clang::import_name("gouge")]] void page_gouge(const leadscrew_gouge* gouge);
[[clang::import_module("page"), clang::import_name("contour")]] void page_contour(const leadscrew_contour* contour);
[[clang::import_module("page"), clang::import_name("modes")]] void page_modes(const leadscrew_modes* modes);
[[clang::import_module("page"), clang::import_name("progress")]] int page_progress(double share);

[[clang::import_module("page"), clang::import_name("text")]] int page_text(const char* text, size_t length);

leadscrew_error_function leadscrew_page_on_diagnostic() {
  return [](const leadscrew_error* error, void*) { page_diagnostic(error); };
}
leadscrew_block_function leadscrew_page_on_block() {
  return [](const leadscrew_block* block, void*) { page_block(block); };
}
leadscrew_tool_function leadscrew_page_on_tool() {
  return [](const leadscrew_tool* tool, void*) { page_tool(tool); };
}
leadscrew_surface_function leadscrew_page_on_surface() {
  return [](const leadscrew_surface* surface, void*) { page_surface(surface); };
}
leadscrew_gouge_function leadscrew_page_on_gouge() {
  return [](const leadscrew_gouge* gouge, void*) { page_gouge(gouge); };
}
leadscrew_contour_function leadscrew_page_on_contour() {
  return [](const leadscrew_contour* contour, void*) { page_contour(contour); };
}
leadscrew_modes_function leadscrew_page_on_modes() {
  return [](const leadscrew_modes* modes, void*) { page_modes(modes); };
}
leadscrew_progress_function leadscrew_page_on_progress() {
  return [](double share, void*) { return page_progress(share); };
}
leadscrew_text_function leadscrew_page_on_text() {
  return [](const char* text, size_t length, void*) { return page_text(text, length); };
}
}
// NOLINTEND(readability-identifier-naming)
