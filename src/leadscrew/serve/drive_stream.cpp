#include <fmt/format.h>

#include <algorithm>
#include <leadscrew/serve/drive_stream.hpp>
#include <leadscrew/serve/request.hpp>
#include <utility>

namespace leadscrew::serve {

namespace {

constexpr double sample_interval = 0.02;   // s
constexpr std::size_t kept_samples = 256;  // five seconds of them
constexpr std::size_t most_asked = 64;     // wishes between two looks at them
constexpr std::int64_t largest_text = 64 << 20;

/// Empty of a program that is longer than a page would show.
base::Result<std::string> text_of(const files::InputFile& program) {
  if (program.size() > largest_text) return std::string();
  return files::all_of(program.source(), program.size(), program.name());
}

}  // namespace

DriveStream::DriveStream(const drive::Setup& setup, drive::Wishes& wishes)
    : setup_(setup),
      wishes_(wishes),
      periods_per_sample_(std::max<std::int64_t>(1, setup.words_in(sample_interval))),
      channel_(kept_samples) {}

DriveStream::~DriveStream() {
  channel_.close();
  server_.reset();
}

base::Result<std::unique_ptr<DriveStream>> DriveStream::open(const files::InputFile& program, const drive::Setup& setup,
                                                             Options options, drive::Wishes& wishes) {
  const auto folder = page_folder();
  if (!folder) return base::failure(folder.error());
  auto page = Page::read(*folder);
  if (!page) return base::failure(page.error());
  auto text = text_of(program);
  if (!text) return base::failure(text.error());
  std::unique_ptr<DriveStream> stream(new DriveStream(setup, wishes));
  if (options.may_control) stream->token_ = new_secret();
  if (stream->token_ && stream->token_->empty())
    return base::failure(base::problem("io-open", "the system gives no random numbers for a token", {}));
  Live live{stream->channel_,
            machine_event(setup.machine, {program.name(), !text->empty(), options.may_control}),
            std::move(*text),
            setup.machine_file,
            setup.tool_table,
            stream->token_,
            [&stream = *stream](std::string_view body) { return stream.control(body); }};
  auto server = Server::open(std::move(*page), options.port, std::move(live));
  if (!server) return base::failure(server.error());
  stream->server_ = std::move(*server);
  return stream;
}

std::string DriveStream::text() const {
  const std::string address = server_->address();
  return token_ ? fmt::format("live at {}program.html, token {}", address, *token_)
                : fmt::format("live at {}program.html", address);
}

drive::Onlooker DriveStream::join(const drive::Onlooker& onlooker) {
  drive::Onlooker joined = onlooker;
  // The process of the drives has been made by now, without threads of ours.
  joined.at_begin = [this, begin = onlooker.at_begin] {
    server_->start();
    if (begin) begin();
  };
  joined.observe = [this, tell = onlooker.observe](const drive::Feedback& feedback) {
    observe(feedback);
    if (tell) tell(feedback);
  };
  joined.while_returning = [this, ask = onlooker.while_returning](double seconds) {
    for (const Wish& wish : take_wishes()) stops_ = stops_ || wish.stop;
    const bool is_unwanted = ask && ask(seconds);
    return is_unwanted || stops_;
  };
  joined.while_moving = [this, ask = onlooker.while_moving](const drive::WordMaker& maker, realtime::Runner& runner) {
    const bool is_unwanted = ask && ask(maker, runner);
    return obey(maker, runner) || is_unwanted;
  };
  if (token_ && !joined.may_start)
    joined.may_start = [this](const planner::Chunk& chunk) { return wishes_.pause.may_start(chunk); };
  joined.at_end = [this, end = onlooker.at_end] {
    channel_.publish(sample_event(setup_.machine, last_, state_));
    channel_.publish(end_event());
    channel_.close();
    if (end) end();
  };
  return joined;
}

bool DriveStream::control(std::string_view body) {
  const auto wish = wish_of(body);
  if (!wish) return false;
  const std::lock_guard lock(mutex_);
  if (asked_.size() >= most_asked) return false;
  asked_.push_back(*wish);
  return true;
}

std::vector<Wish> DriveStream::take_wishes() {
  const std::lock_guard lock(mutex_);
  return std::exchange(asked_, {});
}

void DriveStream::observe(const drive::Feedback& feedback) {
  last_ = feedback;
  if (periods_++ % periods_per_sample_ == 0) channel_.publish(sample_event(setup_.machine, feedback, state_));
}

bool DriveStream::obey(const drive::WordMaker& maker, realtime::Runner& runner) {
  const auto wishes = take_wishes();
  for (const Wish& wish : wishes) {
    wishes_.held = wish.hold.value_or(wishes_.held);
    wishes_.set_factor(wish.override_factor.value_or(wishes_.factor));
    if (wish.go_on && wishes_.stand_at_pause(runner.counters(), last_.word)) wishes_.pause.go_on();
    stops_ = stops_ || wish.stop;
  }
  if (!wishes.empty()) wishes_.tell(runner);
  state_ = state_of(maker, runner.counters());
  return stops_;
}

LiveState DriveStream::state_of(const drive::WordMaker& maker, const realtime::Counters& counters) const {
  using Kind = LiveState::Kind;
  LiveState state{.kind = last_.word.state == base::MotionState::rest ? Kind::resting : Kind::moving,
                  .override_factor = wishes_.factor,
                  .pause_line = std::nullopt};
  if (wishes_.stand_at_pause(counters, last_.word)) {
    state.kind = Kind::paused;
    if (const auto line = wishes_.pause.line()) state.pause_line = base::number(*line);
  }
  if (maker.waits_for_input()) state.kind = Kind::waiting;
  switch (wishes_.hold_state(counters, last_.word)) {
    case drive::HoldState::none:
      break;
    case drive::HoldState::obeyed:
      state.kind = Kind::held;
      break;
    case drive::HoldState::waits:
      state.kind = Kind::hold_waits;
      break;
    case drive::HoldState::refused:
      state.kind = Kind::hold_refused;
      break;
  }
  if (stops_) state.kind = Kind::stopping;
  return state;
}

}  // namespace leadscrew::serve
