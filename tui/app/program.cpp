#include "tui/app/program.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/app/actions.hpp"
#include "tui/app/mode_actions.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/compare_view.hpp"
#include "tui/views/diagnose_view.hpp"
#include "tui/views/frf_view.hpp"
#include "tui/views/modes_view.hpp"
#include "tui/views/recording_view.hpp"
#include "tui/views/report_view.hpp"
#include "tui/views/update_view.hpp"

#include <fmt/format.h>

#include <utility>

namespace tapfit::tui {
namespace {

constexpr std::size_t recording_screen = 0;
constexpr std::size_t frf_screen = 1;
constexpr std::size_t modes_screen = 2;
constexpr std::size_t update_screen = 5;

}  // namespace

Program::Program(std::unique_ptr<Workbench> bench,
                 const Canvas& canvas,
                 const Settings& settings)
    : canvas_(canvas), bound_(settings.keys), worker_(std::move(bench)) {
  auto recording_page = std::make_unique<RecordingPage>();
  recording_page_ = recording_page.get();
  FrfState frf_state;
  frf_state.scale = settings.magnitude;
  frf_state.log_f = settings.log_frequency;
  auto frf_page = std::make_unique<FrfPage>(std::move(frf_state));
  frf_page_ = frf_page.get();
  auto modes_page = std::make_unique<ModesPage>();
  modes_page_ = modes_page.get();
  auto diagnose_page = std::make_unique<DiagnosePage>();
  diagnose_page_ = diagnose_page.get();
  auto update_page = std::make_unique<UpdatePage>(settings.magnitude);
  update_page_ = update_page.get();
  pages_ = {std::move(recording_page),
            std::move(frf_page),
            std::move(modes_page),
            std::make_unique<ComparePage>(settings.magnitude),
            std::move(diagnose_page),
            std::move(update_page),
            std::make_unique<ReportPage>()};
  if (!settings.faults.empty()) tell(fault_words(settings), true);
  tick();
}

Program::~Program() = default;

void Program::resize(int width, int height) {
  const bool fitted = panes().has_value();
  canvas_.width = width;
  canvas_.height = height;
  changed_ = true;
  if (fitted && !panes()) tell(split_needs());
}

std::vector<KeyHelp> Program::page_keys() const {
  if (lacks_input(page())) return {};
  std::vector<KeyHelp> keys = page().keys(known_);
  for (const char* command : {"plot", "copy"}) {
    for (const KeyBinding& usual : usual_bindings()) {
      if (usual.command != command) continue;
      keys.push_back({key_label(usual.key), usual.brief});
    }
  }
  if (panes()) keys.insert(keys.begin(), {"^W", "w: other screen"});
  for (const KeyBinding& own : bound_) {
    std::erase_if(
        keys, [&](const KeyHelp& k) { return k.key == key_label(own.key); });
    keys.push_back({key_label(own.key), own.brief});
  }
  return keys;
}

void Program::start(Job job) {
  running_ = true;
  running_need_ = job.need;
  stopped_by_user_ = false;
  worker_.start(std::move(job));
  changed_ = true;
}

void Program::know(Snapshot now) {
  for (const auto& one : pages_) one->follow(known_, now);
  known_ = std::move(now);
}

void Program::finish(Finished finished) {
  running_ = false;
  if (message_is_to_wait_) tell("");
  const bool opened = !known_.bundle;
  know(std::move(finished.snapshot));
  // Ready FRFs have no recordings to begin with, and modes no FRFs.
  if (opened && known_.bundle && known_.bundle->frfs) current_ = frf_screen;
  if (opened && known_.bundle && known_.bundle->modes) current_ = modes_screen;
  const bool action = !finished.need;
  const bool leaving = action && std::exchange(quit_asked_, false);
  using How = Finished::How;
  if (finished.how == How::Failed) {
    if (finished.need) failed_[*finished.need] = finished.message;
    tell(finished.message, true);
  } else if (finished.how == How::Stopped && stopped_by_user_) {
    if (finished.need) failed_[*finished.need] = "stopped";
    tell("stopped: " + finished.title);
  } else if (finished.how == How::Done && action && !finished.title.empty()) {
    failed_.clear();
    if (!finished.message.empty()) tell(finished.message);
    if (finished.title.starts_with("adding")) {
      if (!screen_chosen_) turn_to(update_screen);
      diagnose_page_->untag();
      update_page_->mark_latest();
    }
  } else if (finished.how == How::Done && !finished.message.empty()) {
    tell(finished.message, true);
  }
  if (leaving && finished.how == How::Done) ask_to_quit();
  changed_ = true;
}

bool Program::tick() {
  if (std::optional<Finished> finished = worker_.take_finished()) {
    finish(std::move(*finished));
  }
  give_way_to_screens();
  if (!running_ && !actions_.empty()) {
    Job job = std::move(actions_.front());
    actions_.pop_front();
    start(std::move(job));
  }
  if (!running_) {
    if (const std::optional<Need> need = next_need()) start(make(*need));
  }
  WorkerStatus status = worker_.status();
  const long seconds = seconds_of(status);
  if (status.errors.size() != shown_.errors.size() ||
      status.stage != shown_.stage || status.fraction != shown_.fraction ||
      status.busy != shown_.busy || seconds != shown_seconds_) {
    changed_ = true;
  }
  if (status.busy && status.tried && status.tried != known_.preliminary) {
    Snapshot now = known_;
    now.preliminary = status.tried;
    know(std::move(now));
    changed_ = true;
  }
  shown_ = std::move(status);
  shown_seconds_ = seconds;
  return std::exchange(changed_, false);
}

bool Program::animate() {
  if (help_open_) return false;
  bool moved = false;
  for (const std::size_t screen : shown_screens()) {
    Page& one = *pages_[screen];
    moved = (ready(one) && one.animate(known_)) || moved;
  }
  return moved;
}

void Program::tell(const std::string& text, bool error) {
  message_ = text;
  message_is_error_ = error;
  message_is_to_wait_ = false;
  changed_ = true;
}

void Program::act(Job job) {
  screen_chosen_ = false;
  actions_.push_back(std::move(job));
  // What is being computed would be out of date; the action goes first.
  if (running_ && running_need_) worker_.stop();
}

void Program::retry() {
  failed_.clear();
  tell("");
}

void Program::leave() {
  actions_.clear();
  worker_.stop();
}

void Program::ask_to_quit() {
  const bool works = !actions_.empty() || acting();
  quit_asked_ = works || known_.unsaved;
  quit_ = !quit_asked_ || quit_asked_before_;
  if (quit_) return;
  if (!works) {
    return tell(
        "what was done could not be saved and would be lost; q again leaves",
        true);
  }
  const std::string what =
      actions_.empty() ? shown_.title : actions_.back().title;
  tell(fmt::format("{} ends first, then tapfit: q leaves now, Esc stays",
                   clipped(what, 26)));
}

void Program::go_to(std::size_t index) {
  screen_chosen_ = true;
  crumbs_.push_back(current_);
  turn_to(index);
  mode_ = Mode::Normal;
}

void Program::turn_to(std::size_t index) {
  if (index == current_) return;
  if (split_ && split_->other == index) return change_focus();
  before_ = current_;
  current_ = index;
}

bool Program::go_back() {
  if (crumbs_.empty()) return false;
  screen_chosen_ = true;
  turn_to(crumbs_.back());
  crumbs_.pop_back();
  return true;
}

void Program::show_screen(std::size_t index) {
  screen_chosen_ = true;
  crumbs_.clear();
  turn_to(index);
  mode_ = Mode::Normal;
}

void Program::press(Key key) {
  changed_ = true;
  if (key == keys::resize) return;
  const std::optional<Held> held = std::exchange(held_, std::nullopt);
  if (key.code == keys::release) return drag(held, key);
  if (scroll_help(key)) return;
  const bool covered = help_open_ || boxed();
  help_open_ = false;
  tell("");  // what was told has been read
  quit_asked_before_ = std::exchange(quit_asked_, false);
  if (const auto asked = std::exchange(asked_to_replace_, std::nullopt)) {
    return answer_replacing(*asked, key);
  }
  // The key that closes a box does nothing else, but that it may answer what
  // the box asks.
  if (covered && !quit_asked_before_) return;
  if (key.code == keys::click) return mouse(key);
  if (zoom_by_wheel(key)) return;
  if (mode_ == Mode::Filter) return press_filter(key);
  if (mode_ == Mode::Colon) return press_colon(key);
  press_normal(key);
}

void Program::press_normal(Key key) {
  if (std::exchange(window_key_, false)) return press_after_window_key(key);
  if (const KeyBinding* own = binding_of(bound_, key)) {
    return run_colon(own->command);
  }
  if (!key.ctrl && key.code >= U'1' && key.code <= U'7') {
    return show_screen(key.code - U'1');
  }
  if (!key.ctrl && ready(page())) {
    Command command;
    if (page().press(known_, key, command)) return carry_out(command);
  }
  press_global(key);
}

void Program::press_global(Key key) {
  if (const KeyBinding* usual = binding_of(usual_bindings(), key)) {
    run_colon(usual->command);
  } else if (key == Key(U'w', true)) {
    window_key_ = true;
    tell("^W: w other screen, v split, o only this one, c only the other");
  } else if (key == U':') {
    mode_ = Mode::Colon;
    typed_.clear();
  } else if (key == U'/' && page().list() != nullptr) {
    mode_ = Mode::Filter;
  } else if (key == Key(U'c', true) && running_) {
    stop_work();
  } else if (key == keys::escape || key == Key(U'c', true)) {
    escape();
  } else if (key == keys::back_tab) {
    show_screen((current_ + pages_.size() - 1) % pages_.size());
  } else if (key.code < 0xE000 && !key.ctrl) {
    const bool waits = !ready(page()) && running_;
    tell(waits ? fmt::format("{} has to wait for the result", name(key))
               : fmt::format("{} does nothing here; ? shows the keys",
                             name(key)));
    message_is_to_wait_ = waits;
  }
}

void Program::step_back() {
  act(current_ == recording_screen ? restore_hits()
      : current_ == modes_screen   ? undo_modes()
                                   : undo());
}

void Program::step_on() {
  act(current_ == recording_screen ? overrule_again()
      : current_ == modes_screen   ? redo_modes()
                                   : redo());
}

void Program::keep_reached() {
  if (!acting()) return tell("no fit runs that could be kept");
  worker_.keep();
  tell("ending with what is reached …");
}

void Program::stop_work() {
  stopped_by_user_ = true;
  actions_.clear();
  worker_.stop();
  tell("stopping …");
}

// What lies on top goes first: what was asked for, a filter, a view in the main
// one's place, the way back; then work that goes on beside.
void Program::escape() {
  if (quit_asked_before_) return;  // it takes that back, and nothing else
  if (running_ && (acting() || !ready(page()))) return stop_work();
  ListState* list = page().list();
  const bool filtered = list != nullptr && !list->filter.empty();
  if (filtered) list->filter.clear();
  if (filtered || (ready(page()) && page().leave_view()) || go_back()) return;
  running_ ? stop_work() : tell("q quits");
}

void Program::carry_out(const Command& command) {
  if (!command.message.empty()) tell(command.message);
  message_is_to_wait_ = command.until_done;
  switch (command.kind) {
    case Command::Kind::None:
      return;
    case Command::Kind::OverruleHit:
      return act(overrule_hits(command.hits));
    case Command::Kind::Add:
      return act(add_effects(command.effects));
    case Command::Kind::Toggle:
      return act(toggle_effect(command.added));
    case Command::Kind::Write:
      return write(command.output, {});
    case Command::Kind::PickPole:
      return act(add_mode(command.hz.value_or(0.0)));
    case Command::Kind::DropMode:
      return act(drop_mode(command.hz.value_or(0.0)));
    case Command::Kind::ShowRun:
      recording_page_->select(command.run);
      return go_to(0);
    case Command::Kind::ShowMode:
      modes_page_->select(command.mode, command.model_mode);
      return go_to(2);
    case Command::Kind::ShowFrf:
      frf_page_->select(command.frf, command.hz);
      return go_to(1);
  }
}

}  // namespace tapfit::tui
