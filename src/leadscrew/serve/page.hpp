#pragma once
// The files of the workbench, read whole into memory before anything is served: no request reads a file. So no name,
// however it is written, leads out of the folder, and no file that changes meanwhile is served by halves.

#include <cstdint>
#include <filesystem>
#include <leadscrew/base/result.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::serve {

struct PageFile {
  std::string text;
  std::string_view type;  ///< as Content-Type has it
};

class Page {
 public:
  static constexpr std::size_t most_files = 1024;
  static constexpr std::int64_t most_bytes = 64 << 20;

  /// Every regular file below the folder, and no symbolic link. Errors: `io-open`, `io-read`, `input-too-large`,
  /// `io-no-page` where there is no index.html.
  static base::Result<Page> read(const std::filesystem::path& folder);

  /// Of a decoded path, "/" or "/assets/index.js"; "/" is index.html. Null where there is none.
  const PageFile* find(std::string_view path) const;

  /// Says in every page of HTML that a machine can be watched, as <meta name="leadscrew-live">.
  void mark_live();

 private:
  std::map<std::string, PageFile, std::less<>> files_;  ///< by their paths, "/assets/index.js"
};

/// The folder of the page: beside the running command as it was installed (share/leadscrew/web), or in the build tree
/// (build/web/page). Errors: `io-no-page` where it is in neither.
base::Result<std::filesystem::path> page_folder();
/// The same, where the command is in this folder.
base::Result<std::filesystem::path> page_folder(const std::filesystem::path& command_folder);

}  // namespace leadscrew::serve
