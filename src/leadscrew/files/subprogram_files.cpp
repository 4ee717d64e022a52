// Subprograms in files of their own, found by their names.

#include <algorithm>
#include <filesystem>
#include <leadscrew/files/input_file.hpp>

namespace leadscrew::files {

namespace {

constexpr std::string_view endings[] = {".ngc", ".nc", ".tap", ".cnc", ".gcode", ".NGC", ".NC", ".TAP", ".CNC", ""};
constexpr std::size_t most_subprogram_files = 500;

bool is_number(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) { return '0' <= c && c <= '9'; });
}

/// What a file of the subprogram may be called, but for its ending.
std::vector<std::string> stems_of(const std::string& name) {
  if (!is_number(name)) return {name};
  std::string four = name;
  while (four.size() < 4) four.insert(four.begin(), '0');
  std::vector<std::string> stems = {name};
  for (const char letter : {'O', 'o'}) stems.push_back(letter + name);
  if (four == name) return stems;
  stems.push_back(four);
  for (const char letter : {'O', 'o'}) stems.push_back(letter + four);
  return stems;
}

std::string path_of(const std::string& name, const std::vector<std::string>& folders) {
  std::error_code error;
  for (const std::string& folder : folders) {
    for (const std::string& stem : stems_of(name)) {
      for (const std::string_view ending : endings) {
        const std::filesystem::path path = std::filesystem::path(folder) / (stem + std::string(ending));
        if (std::filesystem::is_regular_file(path, error)) return path.string();
      }
    }
  }
  return {};
}

}  // namespace

base::TextOpener InputFile::opener(std::vector<std::string> folders) const {
  if (name_ != "<stdin>") {
    const std::string own = std::filesystem::path(name_).parent_path().string();
    folders.insert(folders.begin(), own);
  }
  return [this, folders = std::move(folders)](const std::string& name,
                                              std::int64_t offset) -> base::Result<base::OpenedText> {
    if (name.empty()) return base::OpenedText{source_at(offset), name_};
    const auto file = subprogram(name, folders);
    if (!file) return base::failure(file.error());
    return base::OpenedText{(*file)->source_at(offset), (*file)->name()};
  };
}

base::Result<const InputFile*> InputFile::subprogram(const std::string& name,
                                                     const std::vector<std::string>& folders) const {
  if (const auto known = subprograms_.find(name); known != subprograms_.end()) return known->second.get();
  const bool is_file_name = name.find('/') == std::string::npos && name != "." && name != "..";
  const std::string path = is_file_name ? path_of(name, folders) : std::string();
  if (path.empty()) {
    return base::failure(base::problem("missing-sub", "no file " + name + ".ngc is in its folders",
                                       folders.empty() ? "" : "put it beside the program"));
  }
  if (subprograms_.size() >= most_subprogram_files) {
    return base::failure(base::problem("too-many-files",
                                       "more than " + std::to_string(most_subprogram_files) + " files of subprograms",
                                       "put several subprograms into a file"));
  }
  auto file = InputFile::open(path, "program-changed");
  if (!file) return base::failure(file.error());
  return in_order_.emplace_back(
      subprograms_.emplace(name, std::make_unique<InputFile>(std::move(*file))).first->second.get());
}

const InputFile* InputFile::text_of(int file) const {
  if (file == 0) return this;
  const auto i = static_cast<std::size_t>(file) - 1;
  return i < in_order_.size() ? in_order_[i] : nullptr;
}

std::vector<const InputFile*> InputFile::subprograms() const {
  std::vector<const InputFile*> files;
  for (const auto& [name, file] : subprograms_) files.push_back(file.get());
  return files;
}

}  // namespace leadscrew::files
