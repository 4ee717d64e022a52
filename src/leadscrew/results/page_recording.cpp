#include <algorithm>
#include <bit>
#include <concepts>
#include <leadscrew/markup/markup.hpp>
#include <leadscrew/results/page_recording.hpp>
#include <limits>
#include <string>

namespace leadscrew::results {

namespace {

using json::Json;

constexpr float least_tolerance = 1e-6F;  // mm; the referee takes no less for a departure

/// Numbers one behind the other, least byte first, in base64; `of` gives one or several of each item.
template <class Number, class Items, class Of>
Json packed(const Items& items, const Of& of) {
  std::string bytes;
  const auto put = [&](Number number) {
    using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t,
                                    std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint8_t>>;
    const auto bits = std::bit_cast<Bits>(number);
    for (std::size_t i = 0; i < sizeof bits; ++i) bytes += static_cast<char>(bits >> 8 * i & 255);
  };
  for (const auto& item : items) {
    if constexpr (std::invocable<Of, decltype(item), decltype(put)>) {
      of(item, put);
    } else {
      put(static_cast<Number>(of(item)));
    }
  }
  return markup::base64(bytes);
}

}  // namespace

PageRecording::PageRecording(const machine::Machine& machine) : machine_(machine) {
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis)) axes_.push_back(axis);
  }
  if (machine.rotary_chain) chain_ = kinematics::chain_of(machine);
}

void PageRecording::observe(const base::PassedEvent& event) {
  using Kind = base::Event::Kind;
  if (event.kind == Kind::programmed_feed || event.kind == Kind::tool_offset || base::changes_tool(event.kind))
    ahead_.push_back(event);
}

/// What events say holds from their words on.
void PageRecording::advance(base::Tick tick) {
  using Kind = base::Event::Kind;
  for (; !ahead_.empty() && ahead_.front().tick <= tick; ahead_.pop_front()) {
    const base::PassedEvent& event = ahead_.front();
    if (event.kind == Kind::programmed_feed)
      feed_asked_ = event.value == 0 ? std::numeric_limits<double>::infinity() : event.value;
    else if (event.kind == Kind::tool_offset)
      offset_[static_cast<std::size_t>(event.output)] = event.value;
    else
      tool_ = static_cast<std::int32_t>(event.value);
  }
}

void PageRecording::observe(const base::Word& word, const std::optional<kinematics::ToolPose>& pose) {
  advance(word.tick);
  last_ = sample_of(word, pose);
  last_.judged = judged_.value_or(Judged());
  if (words_++ % every_ == 0) {
    samples_.push_back(last_);
    judged_.reset();
  }
  if (samples_.size() > most_samples) thin();
}

PageRecording::Judged PageRecording::farther(const Judged& a, const Judged& b) {
  return b.distance / std::max(b.tolerance, least_tolerance) > a.distance / std::max(a.tolerance, least_tolerance) ? b
                                                                                                                   : a;
}

void PageRecording::judge(const referee::MatchedBlock& matched) {
  const Judged judged{static_cast<float>(matched.distance), static_cast<float>(matched.tolerance)};
  judged_ = judged_ ? farther(*judged_, judged) : judged;
}

PageRecording::Sample PageRecording::sample_of(const base::Word& word,
                                               const std::optional<kinematics::ToolPose>& pose) {
  if (words_ == 0) differences_[0] = word.position;
  Sample sample{.position = word.position, .feed = word.feed, .length = word.path_length};
  std::array<base::AxisVector, 3> derivatives{};
  for (const base::Axis axis : axes_) {
    const std::size_t i = base::index(axis);
    double difference = word.position[i], per_period = 1;
    for (std::size_t k = 0; k < differences_.size(); ++k, per_period /= machine_.period.seconds()) {
      const double next = difference - differences_[k][i];
      differences_[k][i] = difference;
      if (k > 0) derivatives[k - 1][i] = difference * per_period;
      difference = next;
    }
    sample.velocity[i] = static_cast<float>(derivatives[0][i]);
    sample.acceleration[i] = static_cast<float>(derivatives[1][i]);
    sample.jerk[i] = static_cast<float>(derivatives[2][i]);
  }
  if (word.state != base::MotionState::rest) {
    sample.hold = pipeline::hold_of(pipeline::near_limits(machine_, derivatives[0], derivatives[1], derivatives[2]),
                                    word.feed, feed_asked_);
  }
  for (std::size_t i = 0; i < 3; ++i)
    sample.tip[i] = static_cast<float>(pose ? pose->tip[i] : word.position[i] - offset_[i]);
  if (pose)
    std::ranges::transform(pose->direction, sample.direction.begin(), [](double x) { return static_cast<float>(x); });
  if (pose && chain_) sample.pole_angle = static_cast<float>(kinematics::angle_to_pole(*chain_, pose->direction));
  sample.line = base::file(word.line) == 0 ? static_cast<std::int32_t>(base::number(word.line)) : 0;
  sample.tool = tool_;
  return sample;
}

void PageRecording::thin() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples_.size(); i += 2) {
    if (i > 0) samples_[i].judged = farther(samples_[i - 1].judged, samples_[i].judged);
    samples_[kept++] = samples_[i];
  }
  if (samples_.size() % 2 == 0) judged_ = samples_.back().judged;
  samples_.resize(kept);
  every_ *= 2;
}

void PageRecording::expect(const gcode::MachinedMove& machined) {
  expected_.push_back(machined);
}

void PageRecording::observe(const pipeline::BlockTime& block) {
  Block taken{block};
  if (!expected_.empty()) {
    const gcode::MachinedMove& machined = expected_.front();
    if (machined.surface) taken.part = 1 + static_cast<std::int32_t>(machined.part);
    if (machined.surface) taken.pass = static_cast<std::int32_t>(machined.pass);
    expected_.pop_front();
  }
  if (blocks_.size() == most_blocks) is_whole_ = false;
  if (is_whole_) blocks_.push_back(taken);
}

/// The last word is one of them.
std::vector<PageRecording::Sample> PageRecording::all() const {
  std::vector<Sample> samples = samples_;
  if (words_ > 0 && (words_ - 1) % every_ != 0) samples.push_back(last_);
  return samples;
}

json::Json PageRecording::samples() const {
  const std::vector<Sample> all = this->all();
  const auto of_axes = [&](auto Sample::* member) {
    return [this, member](const Sample& sample, const auto& put) {
      for (const base::Axis axis : axes_) put((sample.*member)[base::index(axis)]);
    };
  };
  const auto of_three = [](std::array<float, 3> Sample::* member) {
    return [member](const Sample& sample, const auto& put) {
      for (const float value : sample.*member) put(value);
    };
  };
  const auto axis_of_hold = [this](const Sample& sample) {
    return std::ranges::find(axes_, sample.hold.axis) == axes_.end()
               ? 0
               : std::ranges::find(axes_, sample.hold.axis) - axes_.begin();
  };
  Json axes = Json::list();
  for (const base::Axis axis : axes_) axes.push_back(std::string(1, base::letter(axis)));
  Json json =
      Json::object({{"count", all.size()},
                    {"words_each", every_},
                    {"axes", axes},
                    {"position", packed<double>(all, of_axes(&Sample::position))},
                    {"feed", packed<double>(all, [](const Sample& sample) { return sample.feed; })},
                    {"s", packed<double>(all, [](const Sample& sample) { return sample.length; })},
                    {"tip", packed<float>(all, of_three(&Sample::tip))},
                    {"tool", packed<std::int32_t>(all, [](const Sample& sample) { return sample.tool; })},
                    {"line", packed<std::int32_t>(all, [](const Sample& sample) { return sample.line; })},
                    {"hold", packed<std::uint8_t>(all, [](const Sample& sample) { return sample.hold.kind; })},
                    {"hold_axis", packed<std::uint8_t>(all, axis_of_hold)},
                    {"distance", packed<float>(all, [](const Sample& sample) { return sample.judged.distance; })},
                    {"tolerance", packed<float>(all, [](const Sample& sample) { return sample.judged.tolerance; })}});
  if (every_ > 1) {  // else they are differences of what is there
    json["velocity"] = packed<float>(all, of_axes(&Sample::velocity));
    json["acceleration"] = packed<float>(all, of_axes(&Sample::acceleration));
    json["jerk"] = packed<float>(all, of_axes(&Sample::jerk));
  }
  if (!chain_) return json;
  json["direction"] = packed<float>(all, of_three(&Sample::direction));
  json["pole_angle"] = packed<float>(all, [](const Sample& sample) { return sample.pole_angle; });
  return json;
}

json::Json PageRecording::blocks() const {
  std::vector<std::string> causes;
  const auto cause_of = [&](const Block& block) {
    const std::string name = pipeline::name(block.time.cause);
    const auto known = std::ranges::find(causes, name);
    if (known != causes.end()) return known - causes.begin();
    causes.push_back(name);
    return std::ssize(causes) - 1;
  };
  const auto numbers = [this](double pipeline::BlockTime::* member) {
    return packed<double>(blocks_, [member](const Block& block) { return block.time.*member; });
  };
  const auto line_of = [](const Block& block) {
    return base::file(block.time.line) == 0 ? base::number(block.time.line) : 0;
  };
  Json json = Json::object({{"count", blocks_.size()},
                            {"line", packed<std::int32_t>(blocks_, line_of)},
                            {"begin", numbers(&pipeline::BlockTime::begin)},
                            {"seconds", numbers(&pipeline::BlockTime::seconds)},
                            {"least_seconds", numbers(&pipeline::BlockTime::least_seconds)},
                            {"length", numbers(&pipeline::BlockTime::length)},
                            {"feed_asked", numbers(&pipeline::BlockTime::feed_asked)},
                            {"feed_reached", numbers(&pipeline::BlockTime::feed_reached)},
                            {"part", packed<std::uint8_t>(blocks_, [](const Block& block) { return block.part; })},
                            {"pass", packed<std::int32_t>(blocks_, [](const Block& block) { return block.pass; })},
                            {"cause", packed<std::uint8_t>(blocks_, cause_of)}});
  json["causes"] = causes;
  return json;
}

}  // namespace leadscrew::results
