#pragma once
// Which leadscrew made a row. A key holds the version alone: builds of one version are to give one result, on other processors
// too. Builds between two versions may not; so each line of a shard names its own, and a sweep tells of rows that another made.

#include <string>

namespace leadscrew::sweep {

/// The version, and XXH64 of the running command's bytes: "0.1.0 5d1e4c0b9a7f3e21"; the version alone where they cannot be read.
/// Reads them the first time.
const std::string& build_name();

}  // namespace leadscrew::sweep
