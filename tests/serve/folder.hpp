#pragma once
// A folder with a page in it.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace leadscrew::serve {

class PageFolder {
 public:
  PageFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "test-serve-XXXXXX").string();
    path = ::mkdtemp(name.data());
    write("secret", "secret");
    write("page/index.html", "<html><head><title>the page</title></head></html>");
    write("page/assets/code.js", "let x;");
    write("page/assets/engine.wasm", std::string("\0asm", 4));
  }
  ~PageFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  PageFolder(const PageFolder&) = delete;
  PageFolder& operator=(const PageFolder&) = delete;

  void write(const std::string& name, std::string_view text) const {
    std::filesystem::create_directories((path / name).parent_path());
    std::ofstream(path / name, std::ios::binary) << text;
  }
  std::filesystem::path page() const { return path / "page"; }

  std::filesystem::path path;
};

}  // namespace leadscrew::serve
