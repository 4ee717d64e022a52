#include <algorithm>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/files/output_file.hpp>
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

base::Result<void> write_lines(const std::vector<json::Json>& rows, const base::ByteSink& sink) {
  for (const json::Json& row : rows) {
    if (auto written = sink(row.written_in_line() + "\n"); !written) return written;
  }
  return {};
}

base::Result<void> write_results(const std::string& folder, Merged& merged) {
  const std::vector<TableColumn> columns = columns_of(merged.rows);
  const auto write = [&](const std::string& name, const auto& write_rows) {
    const std::string path = folder + "/" + name;
    auto written = write_file(path, write_rows);
    if (written) merged.files.push_back(path);
    return written;
  };
  return write("results.jsonl", [&](const base::ByteSink& sink) { return write_lines(merged.rows, sink); })
      .and_then([&] {
        return write("results.csv", [&](const base::ByteSink& sink) { return write_csv(columns, merged.rows, sink); });
      })
      .and_then([&] {
        return write("results.npy", [&](const base::ByteSink& sink) { return write_npy(columns, merged.rows, sink); });
      });
}

/// A task of the list, or a result of the shards.
struct Found {
  json::Json result;
  double processor_s = 0;
};

base::Result<std::map<Key, Found>> results_of(const std::string& folder) {
  std::map<Key, Found> found;
  const auto take = [&](const ShardLine& line) {
    if (found.contains(line.key)) return;  // done twice: the same
    const auto read = json::Json::parse(line.text);
    const json::Json* const result = read ? read->find("result") : nullptr;
    if (result == nullptr || result->members() == nullptr) return;
    const json::Json* const spent = read->find("spent");
    const json::Json* const processor = spent == nullptr ? nullptr : spent->find("processor_s");
    found.emplace(line.key, Found{*result, processor == nullptr ? 0 : processor->number().value_or(0)});
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

}  // namespace

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

base::Result<Merged> merge(const std::string& folder) {
  const auto tasks = files::read_whole(tasks_file(folder), largest_task_list);
  if (!tasks) return base::failure(tasks.error().code == "io-open" ? no_tasks(folder) : tasks.error());
  const auto found = results_of(folder);
  if (!found) return base::failure(found.error());
  Merged merged;
  for (std::size_t begin = 0, end = 0; begin < tasks->size(); begin = end + 1) {
    end = std::min(tasks->find('\n', begin), tasks->size());
    const auto line = json::Json::parse(std::string_view(*tasks).substr(begin, end - begin));
    const json::Json* const key = line ? line->find("key") : nullptr;
    const json::Json* const place = line ? line->find("place") : nullptr;
    const auto known = key == nullptr || key->text() == nullptr ? std::nullopt : key_of_text(*key->text());
    if (!known || place == nullptr || place->members() == nullptr) return base::failure(no_tasks(folder));
    ++merged.tasks;
    const auto result = found->find(*known);
    if (result == found->end()) continue;
    json::Json row = *place;
    for (const auto& [name, value] : *result->second.result.members()) row[name] = value;
    merged.rows.push_back(std::move(row));
  }
  for (const auto& [key, each] : *found) merged.processor_s += each.processor_s;
  if (auto written = write_results(folder, merged); !written) return base::failure(written.error());
  return merged;
}

}  // namespace leadscrew::sweep
