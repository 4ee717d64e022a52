#include <algorithm>
#include <functional>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/sweep/build.hpp>
#include <leadscrew/sweep/merge.hpp>
#include <leadscrew/sweep/shards.hpp>
#include <leadscrew/sweep/table.hpp>
#include <map>

namespace leadscrew::sweep {

namespace {

constexpr std::int64_t largest_task_list = std::int64_t{4} << 30;

std::string tasks_file(const std::string& folder) {
  return folder + "/tasks.jsonl";
}

/// Writes a file that appears whole, by `write`, which gets its sink.
template <class Write>
base::Result<void> write_file(const std::string& path, Write write) {
  auto file = files::OutputFile::create(path, files::OutputFile::Access::sequential);
  if (!file) return base::failure(file.error());
  if (auto written = write(file->sink()); !written) return written;
  return file->publish();
}

/// Results by their keys, as text: ten million of them have to fit.
struct Results {
  struct Line {
    std::string result;
    std::size_t build;
  };
  std::map<Key, Line> lines;
  std::vector<std::string> builds;
  double processor_s = 0;

  std::size_t number_of(const std::string& build) {
    const auto known = std::ranges::find(builds, build);
    const auto number = static_cast<std::size_t>(known - builds.begin());
    if (known == builds.end()) builds.push_back(build);
    return number;
  }
};

base::Result<Results> results_of(const std::string& folder) {
  Results found;
  const auto take = [&](const ShardLine& line) {
    if (found.lines.contains(line.key)) return;  // done twice: the same
    const ShardParts parts = parts_of(line);
    const auto spent = json::Json::parse(parts.spent);
    if (parts.result.empty() || !spent) return;
    const json::Json* const processor = spent->find("processor_s");
    const json::Json* const build = spent->find("build");
    const bool is_named = build != nullptr && build->text() != nullptr;
    found.lines.emplace(
        line.key, Results::Line{std::string(parts.result), found.number_of(is_named ? *build->text() : std::string())});
    found.processor_s += processor == nullptr ? 0 : processor->number().value_or(0);
  };
  if (auto read = for_each_line(shards_of_sweep(folder), take); !read) return base::failure(read.error());
  return found;
}

base::Diagnostic no_tasks(const std::string& folder) {
  return {base::Severity::error,
          "sweep-tasks",
          "holds no sweep: tasks.jsonl is missing or is none of a sweep",
          "give the folder that --out of a sweep named",
          {.file = folder},
          {}};
}

/// The rows of the tasks, one after the other.
class Rows {
 public:
  Rows(const std::string& folder, const std::string& tasks, const Results& results)
      : folder_(folder), tasks_(tasks), results_(results) {}

  /// Calls with each row. Errors: `sweep-tasks`, those of `take`.
  base::Result<void> for_each(const std::function<base::Result<void>(const json::Json&)>& take) {
    tasks = 0;
    rows_of_builds.assign(results_.builds.size(), 0);
    for (std::size_t begin = 0, end = 0; begin < tasks_.size(); begin = end + 1) {
      end = std::min(tasks_.find('\n', begin), tasks_.size());
      const auto line = json::Json::parse(std::string_view(tasks_).substr(begin, end - begin));
      const json::Json* const key = line ? line->find("key") : nullptr;
      const json::Json* const place = line ? line->find("place") : nullptr;
      const auto known = key == nullptr || key->text() == nullptr ? std::nullopt : key_of_text(*key->text());
      if (!known || place == nullptr || place->members() == nullptr) return base::failure(no_tasks(folder_));
      ++tasks;
      const auto result = results_.lines.find(*known);
      if (result == results_.lines.end()) continue;
      json::Json row = *place;
      const auto found = json::Json::parse(result->second.result);
      if (!found || found->members() == nullptr) continue;
      ++rows_of_builds[result->second.build];
      for (const auto& [name, value] : *found->members()) row[name] = value;
      if (auto taken = take(row); !taken) return taken;
      if (files::interrupted()) return base::failure(files::interruption());
    }
    return {};
  }

  std::int64_t tasks = 0;                    ///< of the last walk
  std::vector<std::int64_t> rows_of_builds;  ///< the same, in the order of the results'

 private:
  const std::string& folder_;
  const std::string& tasks_;
  const Results& results_;
};

/// Columns are known after the first walk, which writes the lines.
base::Result<void> write_tables(const std::string& folder, Rows& rows, const TableColumns& found) {
  const auto columns = found.columns();
  return write_file(folder + "/results.csv", [&](const base::ByteSink& csv_sink) {
    return write_file(folder + "/results.npy", [&](const base::ByteSink& npy_sink) {
      CsvTable csv(columns, csv_sink);
      NpyTable npy(columns, found.rows(), npy_sink);
      return rows
          .for_each([&](const json::Json& row) { return csv.write(row).and_then([&] { return npy.write(row); }); })
          .and_then([&] { return csv.finish(); })
          .and_then([&] { return npy.finish(); });
    });
  });
}

}  // namespace

base::Result<void> write_text(const std::string& path, const std::string& text) {
  return write_file(path, [&](const base::ByteSink& sink) { return sink(text); });
}

std::string shards_of_sweep(const std::string& folder) {
  return folder + "/shards";
}

base::Result<void> write_tasks(const Work& work, const std::string& folder) {
  return write_file(tasks_file(folder), [&](const base::ByteSink& sink) -> base::Result<void> {
    for (std::int64_t task = 0; task < work.count(); ++task) {
      json::Json place = json::Json::object();
      for (auto& [name, value] : work.place(task)) place[name] = value;
      const json::Json line = json::Json::object({{"key", text_of(work.key(task))}, {"place", std::move(place)}});
      if (auto written = sink(line.written_in_line() + "\n"); !written) return written;
    }
    return {};
  });
}

base::Result<Merged> merge(const std::string& folder, const RowSink& see) {
  const auto tasks = files::read_whole(tasks_file(folder), largest_task_list);
  if (!tasks) return base::failure(tasks.error().code == "io-open" ? no_tasks(folder) : tasks.error());
  const auto results = results_of(folder);
  if (!results) return base::failure(results.error());
  Rows rows(folder, *tasks, *results);
  TableColumns columns;
  const auto lines = write_file(folder + "/results.jsonl", [&](const base::ByteSink& sink) {
    base::BlockSink block(sink);
    return rows
        .for_each([&](const json::Json& row) {
          columns.observe(row);
          if (see) see(row);
          block.text() += row.written_in_line() + "\n";
          return block.flush_if_full();
        })
        .and_then([&] { return block.flush(); });
  });
  if (!lines) return base::failure(lines.error());
  if (auto written = write_tables(folder, rows, columns); !written) return base::failure(written.error());
  Merged merged{.tasks = rows.tasks,
                .rows = columns.rows(),
                .processor_s = results->processor_s,
                .files = {folder + "/results.jsonl", folder + "/results.csv", folder + "/results.npy"}};
  for (std::size_t k = 0; k < rows.rows_of_builds.size(); ++k) {
    if (rows.rows_of_builds[k] > 0 && results->builds[k] != build_name())
      merged.rows_of_others[results->builds[k]] = rows.rows_of_builds[k];
  }
  return merged;
}

}  // namespace leadscrew::sweep
