#include "tui/screen/terminal.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/screen/clipboard.hpp"
#include "tui/screen/escape_sequence.hpp"
#include "tui/screen/glyphs.hpp"
#include "tui/screen/held_errors.hpp"
#include "tui/screen/palette.hpp"
#include "tui/screen/shown_pictures.hpp"
#include "tui/screen/terminal_signals.hpp"
#include "tui/screen/terminal_traits.hpp"
#include "tui/screen/window_title.hpp"

#include <ncurses.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <langinfo.h>
#include <poll.h>
#include <unistd.h>
#include <utility>

namespace tapfit::tui {
namespace {

// Of VT340, where graphics are wanted and cells are not known.
constexpr CellPixels usual_cell{10, 20};

// Within this, what follows an Esc belongs to it.
constexpr int escape_delay_ms = 25;

bool wants_no_colour(const TerminalOptions& options) {
  const char* variable = std::getenv("NO_COLOR");
  return options.theme == Theme::Mono ||
         (variable != nullptr && *variable != '\0');
}

enum class Colours { None, Eight, Sixteen, Many };

Colours start_colours(const TerminalOptions& options) {
  if (wants_no_colour(options) || !has_colors()) return Colours::None;
  start_color();
  use_default_colors();
  const int pairs_needed = colour_count * (heat_levels + 1) + 1;
  if (COLORS >= 256 && COLOR_PAIRS > pairs_needed) return Colours::Many;
  return COLORS >= 16 ? Colours::Sixteen : Colours::Eight;
}

short pair_number(Colour colour, int heat) {
  return static_cast<short>(1 + static_cast<int>(colour) + heat * colour_count);
}

void make_pairs(Colours colours, const TerminalOptions& options) {
  if (colours == Colours::None) return;
  const int count = colours == Colours::Many      ? 256
                    : colours == Colours::Sixteen ? 16
                                                  : 8;
  const Palette& inks = palette(count, options.light, options.theme);
  for (int c = 0; c < colour_count; ++c) {
    const auto colour = static_cast<Colour>(c);
    const short ink = inks[static_cast<std::size_t>(c)];
    init_pair(pair_number(colour, 0), ink, -1);
    if (colours != Colours::Many) continue;
    for (int heat = 1; heat <= heat_levels; ++heat) {
      const HeatColour& cell =
          heat_palette(options.light)[static_cast<std::size_t>(heat)];
      init_pair(pair_number(colour, heat), cell.ink, cell.paper);
    }
  }
}

attr_t attributes(const Style& style, bool dims) {
  attr_t bits = A_NORMAL;
  if (style.bold) bits |= A_BOLD;
  if (style.dim && dims) bits |= A_DIM;
  if (style.reverse) bits |= A_REVERSE;
  return bits;
}

/// The other end closed without a signal having reached us: reading would
/// return at once for ever.
bool line_is_gone() {
  pollfd line{STDIN_FILENO, POLLIN, 0};
  return poll(&line, 1, 0) > 0 &&
         (line.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
}

std::optional<Key> mouse_key() {
  MEVENT event;
  if (getmouse(&event) != OK) return std::nullopt;
  Key key;
  if ((event.bstate & BUTTON4_PRESSED) != 0) {
    key.code = keys::wheel_up;
  } else if ((event.bstate & BUTTON5_PRESSED) != 0) {
    key.code = keys::wheel_down;
  } else if ((event.bstate & (BUTTON1_PRESSED | BUTTON1_CLICKED)) != 0) {
    key.code = keys::click;
  } else if ((event.bstate & BUTTON1_RELEASED) != 0) {
    key.code = keys::release;
  } else {
    return std::nullopt;
  }
  key.x = event.x;
  key.y = event.y;
  return key;
}

std::optional<Key> special_key(wint_t code) {
  switch (code) {
    case KEY_ENTER:
      return Key(keys::enter);
    case KEY_BACKSPACE:
      return Key(keys::backspace);
    case KEY_UP:
      return Key(keys::up);
    case KEY_DOWN:
      return Key(keys::down);
    case KEY_LEFT:
      return Key(keys::left);
    case KEY_RIGHT:
      return Key(keys::right);
    case KEY_HOME:
      return Key(keys::home);
    case KEY_END:
      return Key(keys::end);
    case KEY_PPAGE:
      return Key(keys::page_up);
    case KEY_NPAGE:
      return Key(keys::page_down);
    case KEY_DC:
      return Key(keys::remove);
    case KEY_BTAB:
      return Key(keys::back_tab);
    case KEY_RESIZE:
      return Key(keys::resize);
    case KEY_SUSPEND:  // what the Linux console calls Ctrl-Z
      return Key(U'z', true);
    case KEY_MOUSE:
      return mouse_key();
    default:
      return std::nullopt;
  }
}

Key character_key(wint_t code) {
  if (code == '\r' || code == '\n') return Key(keys::enter);
  if (code == '\t') return Key(keys::tab);
  if (code == 27) return Key(keys::escape);
  if (code == 127 || code == 8) return Key(keys::backspace);
  if (code < 32) return Key(static_cast<char32_t>(code + 'a' - 1), true);
  return Key(static_cast<char32_t>(code));
}

/// The key Esc, or what a sequence that terminfo does not know stands for.
std::optional<Key> key_from_escape() {
  timeout(escape_delay_ms);
  const EscapeSequence read =
      read_escape_sequence([]() -> std::optional<char32_t> {
        wint_t code = 0;
        const int kind = get_wch(&code);
        if (kind == OK) return static_cast<char32_t>(code);
        if (kind == KEY_CODE_YES) ungetch(static_cast<int>(code));
        return std::nullopt;
      });
  for (std::size_t i = read.unread.size(); i-- > 0;) {
    unget_wch(static_cast<wchar_t>(read.unread[i]));
  }
  return read.is_one ? read.key : Key(keys::escape);
}

[[noreturn]] void refuse_terminal(const char* why) {
  throw InputError(
      why,
      "environment variable TERM",
      "try TERM=xterm-256color or TERM=vt100, or the commands that "
      "print, such as: tapfit run BUNDLE");
}

/// Whether the terminal's kind has a capability that is a string.
bool is_able(const char* capability) {
  const char* text = tigetstr(capability);
  return text != nullptr && text != reinterpret_cast<const char*>(-1);
}

/// A kind that is not known here, as of a new program at the other end of ssh,
/// mostly does what xterm does.
void start_screen() {
  SCREEN* screen = nullptr;
  const char* const own = nullptr;  // TERM
  for (const char* kind : {own, "xterm-256color", "xterm"}) {
    // Where there is none of the kind, newterm() loses what it has allocated.
    if (screen != nullptr || !is_known_terminal(kind)) continue;
    screen = newterm(kind, stdout, stdin);
  }
  if (screen == nullptr) refuse_terminal("this kind of terminal is not known");
  set_term(screen);
  // What draws anywhere on the screen has to get there.
  if (!is_able("cup")) {
    delscreen(screen);
    restore_modes();
    refuse_terminal("this kind of terminal cannot place its cursor");
  }
}

/// What ncurses does not know of.
void send(const std::string& sequence) {
  std::fwrite(sequence.data(), 1, sequence.size(), stdout);
  std::fflush(stdout);
}

/// The graphics that the user wants, or those that the terminal has.
/// @param typed takes what was read beside the answer
Graphics find_graphics(const TerminalOptions& options,
                       CellPixels& cell,
                       std::string& typed) {
  if (options.graphics == GraphicsWish::Off) return Graphics::None;
  const char* kind = std::getenv("TERM");
  TerminalGraphics has = ask_for_graphics(kind != nullptr ? kind : "");
  typed = std::move(has.typed);
  cell = has.cell;
  if (options.graphics == GraphicsWish::Auto) return has.best();
  if (cell.none()) cell = usual_cell;
  return options.graphics == GraphicsWish::Kitty ? Graphics::Kitty
                                                 : Graphics::Sixel;
}

}  // namespace

struct Terminal::Impl {
  std::optional<HeldErrors> errors;
  std::optional<ShownPictures> pictures;  ///< where it has graphics
  CellPixels cell;
  Colours colours = Colours::None;
  bool blocks = false;
  bool dims = true;   ///< what is faint is
  std::string title;  ///< of the window, where it was named

  void draw(int x, int y, const Cell& cell) const {
    const char32_t shown = blocks ? block_glyph(cell.glyph) : cell.glyph;
    const std::array<wchar_t, 3> glyph{
        static_cast<wchar_t>(shown), static_cast<wchar_t>(cell.mark), 0};
    const bool heated = colours == Colours::Many;
    const short pair =
        colours == Colours::None
            ? short{0}
            : pair_number(cell.style.colour, heated ? cell.style.heat : 0);
    cchar_t drawn;
    // Where there are too few colours for heat, the hottest stand out.
    const bool hottest = !heated && cell.style.heat >= 5;
    const attr_t bits =
        attributes(cell.style, dims) ^ (hottest ? A_REVERSE : A_NORMAL);
    setcchar(&drawn, glyph.data(), bits, pair, nullptr);
    mvadd_wch(y, x, &drawn);
  }
  void remove_pictures() {
    if (pictures) send(pictures->remove());
  }
  /// Pixels of cells change with the font, and what was shown may be gone.
  void draw_anew() {
    const CellPixels now = cell_of_window();
    if (!now.none()) cell = now;
    remove_pictures();
    clearok(curscr, TRUE);
  }
  void give_window_back() {
    if (!title.empty()) send(fetch_title);
    title.clear();
  }
};

Terminal::Terminal(const TerminalOptions& options)
    : impl_(std::make_unique<Impl>()) {
  if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) {
    throw InputError("the screens need a terminal",
                     "standard input and output",
                     "start it in a terminal, or use the commands that print, "
                     "such as: tapfit run BUNDLE --json");
  }
  (void)locale_is_utf8();
  keep_modes();
  std::string typed;
  const Graphics graphics = find_graphics(options, impl_->cell, typed);
  start_screen();
  impl_->errors.emplace();
  raw();
  noecho();
  nonl();
  keypad(stdscr, TRUE);
  set_escdelay(escape_delay_ms);
  curs_set(0);
  if (!options.no_mouse) {
    mouseinterval(0);
    mousemask(
        BUTTON1_PRESSED | BUTTON1_RELEASED | BUTTON4_PRESSED | BUTTON5_PRESSED,
        nullptr);
  }
  impl_->colours = start_colours(options);
  impl_->blocks = options.blocks;
  make_pairs(impl_->colours, options);
  impl_->dims = options.theme != Theme::HighContrast;
  if (graphics != Graphics::None) {
    impl_->pictures.emplace(
        graphics,
        inks(options.light,
             wants_no_colour(options) ? Theme::Mono : options.theme));
  }
  for (std::size_t i = typed.size(); i-- > 0;) {
    ungetch(static_cast<unsigned char>(typed[i]));
  }
  take_signals(graphics == Graphics::Kitty);
}

Terminal::~Terminal() {
  give_signals_back();
  impl_->remove_pictures();
  endwin();
  impl_->give_window_back();
  // Without a screen of its own the last one stays, and the prompt goes on it.
  if (!is_able("smcup")) std::fputs("\n", stdout);
}

int Terminal::width() const { return COLS; }
int Terminal::height() const { return LINES; }
bool Terminal::asked_to_end() { return end_was_asked(); }

CellPixels Terminal::pixels() const {
  return impl_->pictures ? impl_->cell : CellPixels{};
}

void Terminal::show(const Screen& screen) {
  erase();
  for (int y = 0; y < std::min(screen.height(), LINES); ++y) {
    for (int x = 0; x < std::min(screen.width(), COLS); ++x) {
      const Cell& cell = screen.at(x, y);
      if (cell.glyph != 0) impl_->draw(x, y, cell);
    }
  }
  ShownPictures::Change change;
  if (impl_->pictures) change = impl_->pictures->show(screen);
  for (const int row : change.rows) {
    if (row < LINES) wredrawln(stdscr, row, 1);
  }
  refresh();
  if (!change.sequence.empty()) send(change.sequence);
}

void Terminal::name_window(const std::string& title) {
  if (title == impl_->title || !has_window_title(std::getenv("TERM"))) return;
  if (impl_->title.empty()) send(put_title_aside);
  impl_->title = title;
  send(title_sequence(title, !locale_is_utf8()));
}

void Terminal::copy(const std::string& text) { send(clipboard_sequence(text)); }

void Terminal::suspend() {
  impl_->remove_pictures();
  impl_->give_window_back();
  // ncurses' own handler leaves the screen, stops, and comes back to it.
  raise(SIGTSTP);
  clearok(curscr, TRUE);
}

std::optional<Key> Terminal::read_key(int milliseconds) {
  timeout(milliseconds);
  wint_t code = 0;
  const int kind = get_wch(&code);
  if (kind == ERR) {
    if (line_is_gone()) ask_to_end();
    if (!was_continued()) return std::nullopt;
    impl_->draw_anew();
    return Key(keys::resize);
  }
  if (kind == KEY_CODE_YES && code == KEY_RESIZE) impl_->draw_anew();
  if (kind == KEY_CODE_YES) return special_key(code);
  return code == 27 ? key_from_escape() : character_key(code);
}

bool locale_is_utf8() {
  std::setlocale(LC_CTYPE, "");
  return std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
}

std::string terminal_library() {
  const std::string name = curses_version();  // "ncurses 6.4.20221231"
  return name.substr(name.find(' ') + 1);
}

}  // namespace tapfit::tui
