// The room tui/app. The program without its terminal.
// In:  Keys.
// Out: Screens, and jobs for the worker.
// May include: its row in CONTRIBUTING.md.
//
// The program without its terminal: keys in, screens out. It keeps the seven
// pages, asks the worker for what the shown one needs, and carries out what
// the user asks for.
#pragma once

#include "tui/app/colon_command.hpp"
#include "tui/app/settings.hpp"
#include "tui/app/split_panes.hpp"
#include "tui/screen/key.hpp"
#include "tui/screen/screen.hpp"
#include "tui/views/page.hpp"
#include "tui/widgets/drawing.hpp"
#include "tui/workbench/worker.hpp"

#include <array>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

class DiagnosePage;
class FrfPage;
class ModesPage;
class RecordingPage;
class UpdatePage;

/// How long the running job has been at it; 0 when there is none.
[[nodiscard]] long seconds_of(const WorkerStatus& status);

class Program {
 public:
  Program(std::unique_ptr<Workbench> bench,
          const Canvas& canvas,
          const Settings& settings = {});
  ~Program();

  void resize(int width, int height);
  /// Plots are drawn in pixels, where there are.
  void draw_in(CellPixels pixels) { canvas_.pixels = pixels; }
  void press(Key key);
  /// Takes what the worker has done and gives it the next work.
  /// @return true when the screen may have changed
  bool tick();
  /// Moves what is animated by a frame; true when the screen has changed.
  bool animate();
  [[nodiscard]] Screen draw() const;
  /// Nothing runs and nothing that the screen needs is missing.
  [[nodiscard]] bool idle() const;
  [[nodiscard]] bool quit() const { return quit_; }
  /// What the screen plots, from top to bottom.
  [[nodiscard]] std::vector<Drawing> plotted() const;
  /// Asks what runs to stop, for good.
  void leave();
  /// Who puts text into the clipboard; nobody where there is no terminal.
  void copy_with(std::function<void(const std::string&)> copy) {
    copy_ = std::move(copy);
  }
  /// Says on each screen what is seen there, or no more.
  void show_tour(bool shown) { tour_ = shown; }
  /// What stands over the window: the test, and how far work is.
  [[nodiscard]] std::string window_title() const;
  /// Work runs, whatever comes of it.
  [[nodiscard]] bool busy() const { return worker_.status().busy; }

 private:
  enum class Mode { Normal, Filter, Colon };

  /// A file that is to be written, and that or a part of it is there.
  struct Replacement {
    Output what;
    std::filesystem::path there;
    std::filesystem::path free;  ///< what it could be named instead
    std::string shown;           ///< the name of what is there
  };

  /// Another screen beside the one that the keys go to.
  struct Split {
    std::size_t other = 0;
    bool other_is_second = true;  ///< to the right or below
  };

  /// Where the mouse's button went down on a plot.
  struct Held {
    Zone plot;
    int x = 0;
  };

  [[nodiscard]] Page& page() const { return *pages_[current_]; }
  /// What it cannot be drawn without is there.
  [[nodiscard]] bool ready(const Page& page) const;
  /// The first result that it cannot be drawn without and that is not there.
  [[nodiscard]] std::optional<Need> missing(const Page& page) const;
  /// It is not there, and nothing has failed on the way to it.
  [[nodiscard]] bool is_wanted(const Need& need) const;
  /// Of what is shown, the first that is wanted.
  [[nodiscard]] std::optional<Need> need_of_screens() const;
  /// The same, then what is worked out beforehand.
  [[nodiscard]] std::optional<Need> next_need() const;
  /// A diagnosis that no screen waits for ends where one waits for something.
  void give_way_to_screens();
  void finish(Finished finished);
  /// Takes over what is known now; the pages keep what is selected on them.
  void know(Snapshot now);
  void start(Job job);

  void press_normal(Key key);
  void ask_to_quit();
  void press_global(Key key);
  void press_filter(Key key);
  void press_colon(Key key);
  void escape();
  void stop_work();
  void mouse(Key key);
  /// The stretch between where the button went down and came up is shown.
  void drag(const std::optional<Held>& from, Key to);
  /// Over a plot, about the place it is over; false for all other keys.
  bool zoom_by_wheel(Key key);
  /// Carries the command of the palette out; one that needs more is typed.
  void choose_command(std::size_t entry);
  void show_screen(std::size_t index);
  /// The same, with a way back by Esc.
  void go_to(std::size_t index);
  bool go_back();
  /// Shows it where the keys go; where a split shows it, they go there.
  void turn_to(std::size_t index);
  void run_mode_action(const ColonCommand& command);
  void run_colon(const std::string& text);
  void run_typed();
  /// Undo and redo of what the screen is about.
  void step_back();
  void step_on();
  void keep_reached();
  void show_run(std::size_t number);
  /// What is known of the test that places are named in.
  [[nodiscard]] effects::TestContext context() const;
  void carry_out(const Command& command);
  /// Writes, or asks first whether a file is to be replaced.
  /// @param named the file; empty: the usual one beside the test
  void write(Output what, const std::string& named);
  void answer_replacing(const Replacement& asked, Key key);
  /// What is still worked out, or why that is not to be had.
  [[nodiscard]] std::string why_no_plot() const;
  /// Writes it under a free name, at once.
  /// @param named without its ending; empty: the screen's beside the test
  void write_plots(const std::string& named);
  void copy_plots();
  void act(Job job);
  /// What runs is what the user asked for, and not a screen's need.
  [[nodiscard]] bool acting() const { return running_ && !running_need_; }
  /// The screen is about what the bundle does not have: a model, recordings.
  [[nodiscard]] bool lacks_input(const Page& page) const;
  /// Those that do something now.
  [[nodiscard]] std::vector<KeyHelp> page_keys() const;
  void retry();
  void tell(const std::string& text, bool error = false);
  /// What is told does not fit its line and stands in a box.
  [[nodiscard]] bool boxed() const;
  /// The filter in force, for the line that messages stand in.
  [[nodiscard]] std::string filter_words() const;

  /// Between the tabs and the two lines below.
  [[nodiscard]] Canvas room() const;
  [[nodiscard]] Screen body(const Canvas& canvas) const;
  [[nodiscard]] Screen drawn(const Page& page, const Canvas& canvas) const;
  [[nodiscard]] Screen waiting(const Page& page, const Canvas& canvas) const;
  /// The tour's words, as many rows as they need; none where they are not
  /// shown.
  [[nodiscard]] Screen tour(const Canvas& canvas) const;
  [[nodiscard]] Screen help(const Canvas& canvas) const;
  [[nodiscard]] std::vector<std::string> help_lines() const;
  void open_help();
  /// False where the key closes the help.
  bool scroll_help(Key key);
  /// Where both screens of a split are in the room; none: only one is shown.
  [[nodiscard]] std::optional<Panes> panes() const;
  /// The screen that the keys go to, and the one beside it.
  [[nodiscard]] std::vector<std::size_t> shown_screens() const;
  /// What the screen that the keys go to has of the room.
  [[nodiscard]] Canvas focused_canvas() const;
  void draw_panes(Screen& screen) const;
  /// Shows another screen beside this one; none named: the one before it.
  void split(std::optional<std::size_t> other);
  void end_split(bool keep_focused);
  void change_focus();
  void focus_at(int x, int y);
  /// The key after Ctrl-W.
  void press_after_window_key(Key key);
  [[nodiscard]] std::string split_needs() const;
  void draw_tabs(Screen& screen) const;
  void draw_line(Screen& screen, int y) const;
  void draw_work(Screen& screen, int y) const;
  void draw_question(Screen& screen, int y) const;
  void draw_live(Screen& screen) const;
  void draw_palette(Screen& screen) const;
  /// " F P": what carries the command out without ':'.
  [[nodiscard]] std::string keys_of(const std::string& command) const;
  void draw_keys(Screen& screen, int y) const;

  Canvas canvas_;
  Snapshot known_;
  std::array<std::unique_ptr<Page>, 7> pages_;
  RecordingPage* recording_page_ = nullptr;  ///< one of pages_
  FrfPage* frf_page_ = nullptr;              ///< another
  ModesPage* modes_page_ = nullptr;          ///< another
  DiagnosePage* diagnose_page_ = nullptr;    ///< another
  UpdatePage* update_page_ = nullptr;        ///< another
  std::size_t current_ = 0;
  std::size_t before_ = 0;  ///< shown before it
  /// By the user, since they asked for something last: its end leaves them
  /// there.
  bool screen_chosen_ = false;
  std::optional<Split> split_;  ///< what is shown beside it
  bool window_key_ = false;     ///< Ctrl-W was the last key
  Mode mode_ = Mode::Normal;
  std::vector<KeyBinding> bound_;    ///< the user's own, before all others
  std::optional<Held> held_;         ///< since the last key
  std::vector<std::size_t> crumbs_;  ///< screens that led here
  std::string typed_;                ///< after ':'
  std::string typed_before_;         ///< and what was carried out last
  std::string message_;
  bool message_is_error_ = false;
  std::optional<Replacement> asked_to_replace_;  ///< the next key answers
  bool message_is_to_wait_ = false;              ///< and ends with what runs
  bool tour_ = false;
  bool help_open_ = false;
  int help_row_ = 0;  ///< the first line shown of a help that is too long
  std::function<void(const std::string&)> copy_;
  bool quit_ = false;
  /// q was the last key and something would be lost: it leaves once that is
  /// done, and at once where q comes again.
  bool quit_asked_ = false;
  bool quit_asked_before_ = false;  ///< by the key before
  bool changed_ = true;

  std::map<Need, std::string> failed_;  ///< not asked for again by itself
  std::deque<Job> actions_;             ///< what the user asked for
  bool running_ = true;                 ///< a job's end has not been taken yet
  std::optional<Need> running_need_;    ///< none where it is an action
  bool stopped_by_user_ = false;
  WorkerStatus shown_;
  long shown_seconds_ = 0;  ///< of shown_
  Worker worker_;           // last: its thread ends before the rest goes
};

}  // namespace tapfit::tui
