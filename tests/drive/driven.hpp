#pragma once
// What `leadscrew drive` leaves behind, read back: rows of words or axes, and its state.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "command.hpp"

namespace leadscrew::cli::testing {

/// Some four seconds with corners to stop at, an arc and a smooth join.
inline const std::string part =
    "G21 G90 G94 G17 F3000\nG61\nG1 X30\nG2 X50 Y-20 I0 J-20\nG1 Y-40\nG64 P0.05\nG1 X20 Y-50\nG1 X0 Y-20\nG61\nG1 X0 "
    "Y0\nG3 X0 Y0 I10 J0\nM2\n";

/// The built-in mill, with a spindle that takes its time and wanders.
inline std::string machine_with_spindle() {
  std::string text = "[spindle]\nacceleration_rpm_s = 2000\nnoise = 0.05\nnoise_period_s = 3\nseed = 7\n";
  for (const char* axis : {"X", "Y", "Z"})
    text += "[axis." + std::string(axis) + "]\ntravel_mm = [-500, 500]\nmax_velocity_mm_s = 200\n" +
            "max_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 20000\nblu_mm = 0.001\n";
  return text;
}

struct Row {
  double t = 0, line = 0, s = 0, feed = 0;
  std::vector<double> q;
};

inline std::vector<Row> rows_of(const std::string& csv) {
  std::vector<Row> rows;
  std::istringstream text(csv);
  std::string line;
  std::getline(text, line);
  while (std::getline(text, line)) {
    std::vector<double> values;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) values.push_back(std::strtod(field.c_str(), nullptr));
    rows.push_back({values[0], values[1], values[2], values[3], {values.begin() + 4, values.end()}});
  }
  return rows;
}

/// Rows of words without their times, the last where axes stand: the same whether or not motion waits there.
inline std::vector<std::string> untimed(const std::string& csv) {
  std::vector<std::string> rows;
  std::istringstream text(csv);
  std::string axes_before;
  for (std::string line; std::getline(text, line);) {
    constexpr int columns_before_axes = 4;
    std::size_t from = 0;
    for (int column = 0; column < columns_before_axes; ++column) from = line.find(',', from) + 1;
    std::string axes = line.substr(from);
    if (axes == axes_before) rows.pop_back();
    rows.push_back(line.substr(line.find(',')));
    axes_before = std::move(axes);
  }
  return rows;
}

/// Where motion stood longest, s, and Z there.
struct Stand {
  double seconds = 0, z = 0;
};

inline Stand longest_stand(const std::vector<Row>& rows) {
  Stand longest;
  for (std::size_t first = 0, k = 0; k < rows.size(); ++k) {
    if (rows[k].q != rows[first].q) first = k;
    if (rows[k].t - rows[first].t > longest.seconds) longest = {rows[k].t - rows[first].t, rows[k].q[2]};
  }
  return longest;
}

inline double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// Where the path is at a length, between two of the words that run made.
inline std::vector<double> at(const std::vector<Row>& path, double s) {
  const auto after = std::find_if(path.begin(), path.end(), [&](const Row& row) { return row.s >= s; });
  if (after == path.end()) return path.back().q;
  if (after == path.begin() || after->s == std::prev(after)->s) return after->q;
  const Row& before = *std::prev(after);
  const double share = (s - before.s) / (after->s - before.s);
  std::vector<double> q = before.q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] += share * (after->q[i] - before.q[i]);
  return q;
}

/// To the nearest place of the path, between two of its words.
inline double distance_to(const std::vector<Row>& path, const std::vector<double>& q) {
  double nearest = distance(path.front().q, q);
  for (std::size_t k = 1; k < path.size(); ++k) {
    const std::vector<double>&a = path[k - 1].q, &b = path[k].q;
    double along = 0, squared = 0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      along += (q[i] - a[i]) * (b[i] - a[i]);
      squared += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double share = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
    std::vector<double> foot = a;
    for (std::size_t i = 0; i < q.size(); ++i) foot[i] += share * (b[i] - a[i]);
    nearest = std::min(nearest, distance(foot, q));
  }
  return nearest;
}

/// The largest first, second or third difference over a limit of the built-in mill, as if it stood before and after.
inline double worst_ratio(std::vector<Row> rows, double T = 1e-3) {
  rows.insert(rows.begin(), 3, rows.front());
  rows.insert(rows.end(), 3, rows.back());
  double worst = 0;
  for (std::size_t k = 3; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < rows[k].q.size(); ++i) {
      const double a = rows[k].q[i], b = rows[k - 1].q[i], c = rows[k - 2].q[i], d = rows[k - 3].q[i];
      worst = std::max({worst, std::abs(a - b) / T / 200, std::abs(a - 2 * b + c) / T / T / 1000,
                        std::abs(a - 3 * b + 3 * c - d) / T / T / T / 20000});
    }
  }
  return worst;
}

inline bool exists(const Folder& folder, const std::string& name) {
  return std::filesystem::exists(folder.path() / name);
}

/// None where there is no such file.
inline std::vector<Row> rows_in(const Folder& folder, const std::string& name) {
  return exists(folder, name) ? rows_of(folder.read(name)) : std::vector<Row>();
}

inline std::string state_of(const Folder& folder) {
  const Json state = Json::parse(folder.read("state"), nullptr, false);
  return state.is_object() ? state["state"].get<std::string>() : "";
}

/// Waits until the state on disk says that the drives have come so far along the path, mm.
inline bool comes_to(const Folder& folder, double length) {
  return eventually([&] {
    if (!std::filesystem::exists(folder.path() / "state")) return false;
    const Json state = Json::parse(folder.read("state"), nullptr, false);
    return state.is_object() && state["path_length"].get<double>() >= length;
  });
}

/// Drives a program of less than a minute, planned to its end before motion begins: however slow the planner is, it is
/// never late, and words are those of run.
inline Outcome drive_without_a_tail(const Folder& folder, std::vector<std::string> arguments,
                                    const std::string& lead = "2s") {
  arguments.insert(arguments.begin(), {"drive", "part.ngc", "--json", "--look-ahead", "60s", "--lead", lead});
  Outcome driven = leadscrew(folder, arguments);
  EXPECT_EQ(driven.status, 0) << driven.errors;
  EXPECT_EQ(driven.json()["starvations"], 0);
  return driven;
}

}  // namespace leadscrew::cli::testing
