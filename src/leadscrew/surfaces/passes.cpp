#include <deque>
#include <leadscrew/surfaces/links.hpp>
#include <leadscrew/surfaces/pass_lines.hpp>
#include <leadscrew/surfaces/passes.hpp>
#include <utility>

namespace leadscrew::surfaces {

class FoundLines {
 public:
  Machining machining;
  std::shared_ptr<const LineRecord> record;  // complete
  std::optional<Passes::Least> least;
};

const Machining& machining_of(const FoundLines& found) {
  return found.machining;
}

std::size_t bytes_of(const FoundLines& found) {
  return sizeof(FoundLines) + found.record->bytes;
}

bool has_same_lines(const Machining& a, const Machining& b) {
  if (a.surface != b.surface && !(a.surface->form() == b.surface->form())) return false;
  Machining of_same = b;
  of_same.surface = a.surface;
  of_same.is_draft = a.is_draft;
  return a == of_same;
}

class Passes::Maker {
 public:
  /// found: or none.
  Maker(Machining machining, const FoundLines* found);

  std::optional<Pass> next() {
    if (ready_.empty() && !log_.failure) make_next();
    if (ready_.empty()) return std::nullopt;
    Pass pass = std::move(ready_.front());
    ready_.pop_front();
    return pass;
  }

  const Machining& machining() const { return machining_; }
  const PassLog& log() const { return log_; }
  std::size_t count() const { return count_; }
  std::shared_ptr<const FoundLines> found_lines() const {
    if (!record_ || !record_->is_complete || log_.failure) return nullptr;
    return std::make_shared<FoundLines>(FoundLines{machining_, record_, log_.least});
  }

 private:
  void make_next();
  bool is_joined(const PassNode& from, const PassNode& to) const;

  Machining machining_;
  PassLog log_;
  std::shared_ptr<LineRecord> record_;  // of a draft
  std::unique_ptr<PassLines> lines_;
  LinkMaker links_{machining_};
  std::deque<Pass> ready_;
  std::optional<PassNode> end_;  // of the pass made last
  std::size_t count_ = 0, nodes_ = 0;
};

Passes::Maker::Maker(Machining machining, const FoundLines* found) : machining_(std::move(machining)) {
  log_.machining = &machining_;
  if (found != nullptr && has_same_lines(found->machining, machining_)) {
    log_.least = found->least;
    lines_ = known_lines(found->record);
    return;
  }
  look_for_edges(log_);
  if (log_.failure) return;
  lines_ = lines_of(log_);
  if (!machining_.is_draft) return;
  record_ = std::make_shared<LineRecord>();
  lines_ = recorded_lines(std::move(lines_), record_);
}

/// Tip and axis where they were.
bool Passes::Maker::is_joined(const PassNode& from, const PassNode& to) const {
  double tip = 0, axis = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    tip += std::abs(from.tip[k][0] - to.tip[k][0]);
    axis += std::abs(from.axis[k][0] - to.axis[k][0]);
  }
  return tip < 1e-9 && axis < 1e-9;
}

void Passes::Maker::make_next() {
  std::deque<Pass> made;
  log_.number = count_;
  const std::vector<Line> lines = lines_->next(log_);
  for (const Line& line : lines) {
    for (Pass& pass : passes_along(log_, line)) {
      if (log_.failure) return;
      const PassNode& begin = pass.nodes.front();
      if (end_ && !is_joined(*end_, begin)) {
        std::optional<Pass> link = links_.between(log_, *end_, begin);
        if (!link) return;
        if (made.empty()) link->number = count_ - 1;
        made.push_back(std::move(*link));
      }
      end_ = pass.nodes.back();
      nodes_ += pass.nodes.size();
      made.push_back(std::move(pass));
    }
    if (nodes_ > most_nodes_in_all) {
      log_.fail(PassFailure::Kind::too_many, end_->u, end_->v, static_cast<double>(nodes_));
    }
    if (log_.failure) return;
  }
  if (!lines.empty()) ++count_;
  ready_ = std::move(made);
}

Passes::Passes(Machining machining) : maker_(std::make_unique<Maker>(std::move(machining), nullptr)) {}
Passes::Passes(Machining machining, const std::shared_ptr<const FoundLines>& found)
    : maker_(std::make_unique<Maker>(std::move(machining), found.get())) {}
Passes::~Passes() = default;
Passes::Passes(Passes&&) noexcept = default;
Passes& Passes::operator=(Passes&&) noexcept = default;

std::optional<Pass> Passes::next() {
  return maker_->next();
}
const std::optional<PassFailure>& Passes::failure() const {
  return maker_->log().failure;
}
const Machining& Passes::machining() const {
  return maker_->machining();
}
std::shared_ptr<const FoundLines> Passes::found_lines() const {
  return maker_->found_lines();
}
std::size_t Passes::count() const {
  return maker_->count();
}
const std::optional<Passes::Least>& Passes::least_clearance() const {
  return maker_->log().least;
}

}  // namespace leadscrew::surfaces
