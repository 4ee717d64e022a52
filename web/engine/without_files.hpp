// Included before toml++, which has a function that opens files: libc++ for wasm32-wasi only names std::ifstream, and nobody
// calls that function here.
#pragma once

#include <istream>
#include <string>

template <>
class std::basic_ifstream<char> : public std::istream {
 public:
  basic_ifstream() : std::istream(nullptr) {}
  void open(const std::string&, std::ios_base::openmode) {}
  bool is_open() const { return false; }
};
