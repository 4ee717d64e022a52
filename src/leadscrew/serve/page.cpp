#include <fmt/format.h>

#include <array>
#include <leadscrew/files/beside_command.hpp>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/serve/page.hpp>
#include <utility>

namespace leadscrew::serve {

namespace {

constexpr std::string_view live_mark = "<meta name=\"leadscrew-live\" content=\"live\" />";

std::string_view type_of(const std::filesystem::path& path) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> types = {
      {{".html", "text/html; charset=utf-8"},
       {".js", "text/javascript; charset=utf-8"},
       {".css", "text/css; charset=utf-8"},
       {".wasm", "application/wasm"},
       {".json", "application/json"},
       {".svg", "image/svg+xml"},
       {".png", "image/png"},
       {".txt", "text/plain; charset=utf-8"}}};
  const std::string ending = path.extension();
  for (const auto& [known, type] : types) {
    if (known == ending) return type;
  }
  return "application/octet-stream";
}

tl::unexpected<base::Diagnostic> unreadable(const std::filesystem::path& path, const std::error_code& error) {
  return base::failure(files::system_failure("io-open", "cannot open", path, error.value()));
}

tl::unexpected<base::Diagnostic> no_page(const std::string& where) {
  return base::failure(base::problem("io-no-page", fmt::format("the workbench is not {}", where),
                                     "script/web builds it, and cmake --install puts it beside the command"));
}

}  // namespace

base::Result<Page> Page::read(const std::filesystem::path& folder) {
  Page page;
  std::int64_t bytes = 0;
  std::error_code error;
  auto entry = std::filesystem::recursive_directory_iterator(folder, error);
  if (error) return unreadable(folder, error);
  for (; entry != std::filesystem::recursive_directory_iterator(); entry.increment(error)) {
    if (error) return unreadable(folder, error);
    // Neither links to files nor to folders are followed.
    if (entry->symlink_status(error).type() != std::filesystem::file_type::regular) continue;
    auto text = files::read_whole(entry->path(), most_bytes - bytes);
    if (!text) return base::failure(text.error());
    bytes += static_cast<std::int64_t>(text->size());
    const std::string name = "/" + entry->path().lexically_relative(folder).generic_string();
    page.files_.insert_or_assign(name, PageFile{std::move(*text), type_of(entry->path())});
    if (page.files_.size() > most_files)
      return base::failure(base::problem("input-too-large",
                                         fmt::format("{} holds more than {} files", folder.string(), most_files), {}));
  }
  if (page.find("/") == nullptr) return no_page(fmt::format("in {}: there is no index.html", folder.string()));
  return page;
}

const PageFile* Page::find(std::string_view path) const {
  const auto found = files_.find(path == "/" ? "/index.html" : path);
  return found == files_.end() ? nullptr : &found->second;
}

void Page::mark_live() {
  constexpr std::string_view head = "<head>";
  for (auto& [name, file] : files_) {
    const std::size_t at = name.ends_with(".html") ? file.text.find(head) : std::string::npos;
    if (at != std::string::npos) file.text.insert(at + head.size(), live_mark);
  }
}

base::Result<std::filesystem::path> page_folder(const std::filesystem::path& command_folder) {
  std::error_code error;
  for (const char* beside : {LEADSCREW_INSTALLED_PAGE, LEADSCREW_BUILT_PAGE}) {
    auto folder = (command_folder / beside).lexically_normal();
    if (std::filesystem::is_regular_file(folder / "index.html", error)) return folder;
  }
  return no_page(fmt::format("there: neither {} nor {} has it",
                             (command_folder / LEADSCREW_INSTALLED_PAGE).lexically_normal().string(),
                             (command_folder / LEADSCREW_BUILT_PAGE).lexically_normal().string()));
}

base::Result<std::filesystem::path> page_folder() {
  const auto command = files::command_folder();
  return command ? page_folder(*command) : base::failure(command.error());
}

}  // namespace leadscrew::serve
