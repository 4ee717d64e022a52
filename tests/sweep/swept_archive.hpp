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

/// What the shards of a sweep say of each task's time, s of the clock and of the processor: a list a shard, in the order in which
/// tasks were done.
struct SpentTime {
  double begin = 0, end = 0, processor = 0;
};
inline std::vector<std::vector<SpentTime>> spent_of(const Folder& folder, const std::string& out) {
  std::vector<std::vector<SpentTime>> all;
  for (const auto& shard : std::filesystem::directory_iterator(folder.path() / out / "shards")) {
    std::ifstream file(shard.path());
    all.emplace_back();
    for (std::string line; std::getline(file, line);) {
      const Json spent = Json::parse(line)["spent"];
      all.back().push_back({spent["begin"], spent["end"], spent["processor_s"]});
    }
  }
  return all;
}

#ifdef LEADSCREW_MPIRUN
/// A sweep on so many ranks.
inline Outcome ranked_sweep(const Folder& folder, const std::string& ranks, const std::vector<std::string>& words,
                            const std::vector<std::string>& of_mpirun = {}) {
  std::vector<std::string> all = of_mpirun;
  all.insert(all.end(), {"-n", ranks, "--oversubscribe", "--allow-run-as-root", Surroundings().command, "sweep"});
  all.insert(all.end(), words.begin(), words.end());
  return leadscrew(folder, all, {.command = LEADSCREW_MPIRUN});
}
#endif

/// Adds to the words programs of some 100 ms each, all a little different.
inline void add_long_programs(const Folder& folder, int count, std::vector<std::string>& words) {
  words.emplace_back("--programs");
  for (int k = 0; k < count; ++k)
    words.push_back(folder.write("p" + std::to_string(k) + ".ngc", long_program(1500 + 100 * k)));
}

}  // namespace leadscrew::cli::testing
