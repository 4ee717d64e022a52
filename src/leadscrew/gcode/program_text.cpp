#include <algorithm>
#include <leadscrew/gcode/program_text.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

ByteSource retained_source(std::shared_ptr<RetainedText> text, std::int64_t offset) {
  return [text = std::move(text), offset](std::span<char> buffer) mutable { return text->read(offset, buffer); };
}

}  // namespace

ProgramText::ProgramText(ByteSource source, TextOpener opener, std::string name)
    : opener_(std::move(opener)), asked_{std::string()}, names_{std::move(name)} {
  if (!opener_) {
    retained_ = std::make_shared<RetainedText>(std::move(source));
    source = retained_source(retained_, 0);
  }
  windows_.push_back(std::make_unique<LineSource>(std::move(source)));
  used_.push_back(0);
  current_ = windows_.front().get();
}

void ProgramText::keep(const TextLine& line) {
  if (retained_ && !retained_->is_asked_for()) retained_->keep(windows_.front()->text_from(line.offset));
}

base::Result<void> ProgramText::go_to(const TextPlace& place) {
  ++goings_;
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    if (!windows_[i]->seek(place.file, place.offset, place.line)) continue;
    used_[i] = goings_;
    current_ = windows_[i].get();
    current_->set_visit(visit_);
    return {};
  }
  ++reopenings_;
  auto source = source_at(place.file, place.offset);
  if (!source) return base::failure(source.error());
  current_ = &free_window();
  current_->restart(std::move(*source), place.file, place.offset, place.line);
  current_->set_visit(visit_);
  return {};
}

base::Result<ByteSource> ProgramText::source_at(int file, std::int64_t offset) {
  if (opener_) {
    auto opened = opener_(asked_[static_cast<std::size_t>(file)], offset);
    if (!opened) return base::failure(opened.error());
    return std::move(opened->source);
  }
  if (auto held = retained_->check(offset); !held) return base::failure(held.error());
  return retained_source(retained_, offset);
}

/// The one that was gone to the longest time ago, or a new one.
LineSource& ProgramText::free_window() {
  if (windows_.size() < most_windows) {
    windows_.push_back(std::make_unique<LineSource>(ByteSource()));
    used_.push_back(goings_);
    return *windows_.back();
  }
  const auto oldest = std::min_element(used_.begin(), used_.end());
  *oldest = goings_;
  return *windows_[static_cast<std::size_t>(oldest - used_.begin())];
}

base::Result<int> ProgramText::open(const std::string& name) {
  const auto found = std::find(asked_.begin() + 1, asked_.end(), name);
  if (found != asked_.end()) return static_cast<int>(found - asked_.begin());
  if (!opener_) {
    return base::failure(base::problem("missing-sub", "there is no file " + name + " beside this text",
                                       "give the program as a file, in the folder of its subprograms"));
  }
  if (names_.size() > static_cast<std::size_t>(base::last_file)) {
    return base::failure(base::problem("too-many-files",
                                       "the program has more than " + std::to_string(base::last_file) + " files",
                                       "put several subprograms into a file"));
  }
  auto opened = opener_(name, 0);
  if (!opened) return base::failure(opened.error());
  asked_.push_back(name);
  names_.push_back(std::move(opened->name));
  return static_cast<int>(names_.size()) - 1;
}

void ProgramText::set_visit(std::int64_t visit) {
  visit_ = visit;
  current_->set_visit(visit);
}

}  // namespace leadscrew::gcode
