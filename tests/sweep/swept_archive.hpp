#pragma once
// Programs of a sweep, and what stands of it.

#include "command.hpp"

namespace leadscrew::cli::testing {

/// Programs of some milliseconds each, one that has an error, and one that is not there.
class SweptArchive {
 public:
  explicit SweptArchive(int programs) {
    std::filesystem::create_directory(folder.path() / "archive");
    for (int k = 0; k < programs; ++k)
      folder.write("archive/p" + std::to_string(k) + ".ngc", with_feed(square, std::to_string(600 + 60 * k)));
    folder.write("archive/bad.ngc", "G21\nG1 X\nM2\n");
    tasks = 2 * (programs + 2);
  }

  std::vector<std::string> words(const std::string& out, std::vector<std::string> more = {}) const {
    std::vector<std::string> all = {"sweep",      "--programs", "archive", "none.ngc", "--tolerance",
                                    "0.001,0.01", "--out",      out,       "--json"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Outcome run(const std::string& out, std::vector<std::string> more = {}) const {
    return leadscrew(folder, words(out, std::move(more)));
  }
#ifdef LEADSCREW_MPIRUN
  /// Of mpirun, with the command that tests of it run.
  std::vector<std::string> ranked_words(const std::string& out, const std::string& ranks) const {
    std::vector<std::string> all = {"-n", ranks, "--oversubscribe", "--allow-run-as-root", Surroundings().command};
    const auto own = words(out);
    all.insert(all.end(), own.begin(), own.end());
    return all;
  }
  Outcome ranked(const std::string& out, const std::string& ranks) const {
    return leadscrew(folder, ranked_words(out, ranks), {.command = LEADSCREW_MPIRUN});
  }
#endif
  std::string rows(const std::string& out) const { return folder.read(out + "/results.jsonl"); }
  /// Whole lines of all shards.
  int lines(const std::string& out) const {
    int lines = 0;
    if (!std::filesystem::exists(folder.path() / out / "shards")) return 0;
    for (const auto& shard : std::filesystem::directory_iterator(folder.path() / out / "shards")) {
      std::ifstream file(shard.path());
      for (std::string line; std::getline(file, line);) lines += line.ends_with("}}") ? 1 : 0;
    }
    return lines;
  }

  Folder folder;
  int tasks = 0;
};

}  // namespace leadscrew::cli::testing
