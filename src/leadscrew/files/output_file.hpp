#pragma once
// A file that appears whole or not at all.
//
// Bytes go to a temporary file in the same folder, which takes the final name when it is published and is removed when
// it is not. What is no regular file (/dev/null, a pipe) is written straight. A process that is killed leaves its
// temporary file behind. While it is written it is locked by flock(2), so that whoever finds one without a lock may
// remove it (remove_left_behind), whatever became of its writer.

#include <initializer_list>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/files/descriptor.hpp>
#include <string>
#include <string_view>

namespace leadscrew::files {

/// Of a path, in small letters: ".csv".
std::string extension(const std::string& path);

/// Where links lead: the file that is made or replaced when this one is written.
std::string target_of(const std::string& path);

/// Makes the folders that lead to the file, those that are missing. Error: `io-open`.
base::Result<void> make_folder_of(const std::string& path);

/// Does standard output go there?
bool is_standard_output(const std::string& path);

/// Removes temporary files and locks of this user that processes which were killed have left in the folder of `path`.
void remove_left_behind(const std::string& path);

class OutputFile {
 public:
  enum class Access { sequential, rewritable };  ///< rewritable: rewrite_start() will be called

  /// Makes missing folders. Errors: `io-open`; a pipe cannot be rewritable.
  static base::Result<OutputFile> create(const std::string& path, Access access);

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();  ///< removes what was not published

  const std::string& path() const { return path_; }

  base::Result<void> write(std::string_view bytes);
  /// Overwrites the first bytes of the file.
  base::Result<void> rewrite_start(std::string_view bytes);
  /// Refers to this file, which must stay where it is.
  base::ByteSink sink();

  /// All bytes have reached the system; nothing more will be written.
  base::Result<void> close();
  /// Takes the final name.
  base::Result<void> publish();
  /// The same, once all bytes are on the disc; the name is there too when it returns.
  base::Result<void> publish_durably();

 private:
  OutputFile() = default;
  base::Result<void> open_temporary();
  bool is_locked() const;

  Descriptor descriptor_;
  std::string path_;       ///< as given, for messages
  std::string target_;     ///< the file that will be replaced
  std::string temporary_;  ///< empty when written straight or published
};

/// Closes all files, then gives them their names: they appear together, or not at all but for a failure of the system
/// between two of them. Null ones are passed over.
base::Result<void> publish_together(std::initializer_list<OutputFile*> files);

}  // namespace leadscrew::files
