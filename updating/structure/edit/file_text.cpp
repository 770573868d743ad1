#include "updating/structure/edit/file_text.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "updating/structure/cards/include_lines.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

namespace tapfit::structure {
namespace {

namespace fs = std::filesystem;

// The lines of a file with their ends, as take_line() parts them.
class WrittenLines {
 public:
  explicit WrittenLines(const fs::path& file) : file_(file) {
    std::ifstream stream = acquisition::open_input(file, max_deck_bytes);
    text_.assign(std::istreambuf_iterator<char>(stream), {});
    std::size_t begin = 0;
    while (begin < text_.size()) {
      std::size_t end = text_.find_first_of("\r\n", begin);
      if (end == std::string::npos) end = text_.size();
      const bool two = text_.compare(end, 2, "\r\n") == 0;
      const std::size_t next = std::min(end + (two ? 2 : 1), text_.size());
      starts_.push_back(begin);
      ends_.push_back(end);
      begin = next;
    }
    starts_.push_back(text_.size());
  }

  // As written, with the end of the last one.
  [[nodiscard]] std::string_view lines(const LineOrigin& at) const {
    const auto from = static_cast<std::size_t>(at.first - 1);
    const auto to = from + static_cast<std::size_t>(at.count);
    if (to >= starts_.size()) {
      throw InputError("was changed while it was read",
                       file_.string(),
                       "write the deck again");
    }
    return std::string_view(text_).substr(starts_[from],
                                          starts_[to] - starts_[from]);
  }

  // Of the last line of these; empty where the file ends in it.
  [[nodiscard]] std::string_view end(const LineOrigin& at) const {
    const auto last = static_cast<std::size_t>(at.first + at.count - 2);
    return std::string_view(text_).substr(ends_[last],
                                          starts_[last + 1] - ends_[last]);
  }

  // Of the first line.
  [[nodiscard]] std::string usual_end() const {
    if (ends_.empty() || ends_[0] == starts_[1]) return "\n";
    return text_.substr(ends_[0], starts_[1] - ends_[0]);
  }

 private:
  fs::path file_;
  std::string text_;
  std::vector<std::size_t> starts_;  // and the end of all
  std::vector<std::size_t> ends_;    // in front of their line ends
};

// Puts lines together; a line may hold several.
class TextWriter {
 public:
  explicit TextWriter(std::string usual) : usual_(std::move(usual)) {}

  void as_written(std::string_view lines) {
    end_line();
    text_ += lines;
  }

  // @param last end of the last one
  void add(const std::vector<std::string>& lines, std::string_view last) {
    for (std::size_t k = 0; k < lines.size(); ++k) {
      end_line();
      for (const char c : lines[k]) c == '\n' ? text_ += usual_ : text_ += c;
      text_ += k + 1 < lines.size() ? usual_ : last;
    }
  }

  [[nodiscard]] const std::string& usual() const { return usual_; }
  [[nodiscard]] std::string& text() { return text_; }

 private:
  void end_line() {
    if (text_.empty() || text_.back() == '\n' || text_.back() == '\r') return;
    text_ += usual_;
  }

  std::string usual_;
  std::string text_;
};

bool share_a_folder(const fs::path& one, const fs::path& other) {
  const auto a = one.relative_path();
  const auto b = other.relative_path();
  return a.begin() != a.end() && b.begin() != b.end() &&
         *a.begin() == *b.begin();
}

// The names by which a file may be called, the preferred one first.
std::vector<std::string> names_for(const EditedLayout& layout,
                                   std::size_t asks,
                                   const FileAsked& asked) {
  const fs::path to = resolved_place(layout.places.at[asked.file]);
  const auto folder_of = [](const fs::path& folder) {
    return resolved_place(folder.empty() ? "." : folder);
  };
  const fs::path beside = folder_of(layout.places.at[asks].parent_path());
  const fs::path main = folder_of(layout.places.folder);
  std::vector<std::string> names{to.lexically_relative(beside).string(),
                                 to.lexically_relative(main).string(),
                                 to.string()};
  // As it was asked for before: beside the file, or beside the deck.
  const fs::path& original = layout.files[asks].original;
  std::error_code fault;
  if (!fs::exists(original.parent_path() / asked.name, fault)) {
    std::swap(names[0], names[1]);
  }
  if (!share_a_folder(to, beside)) std::swap(names[0], names[2]);
  return names;
}

// What is read of such lines.
std::optional<std::string> name_read(const std::vector<std::string>& lines,
                                     bool keywords) {
  std::stringstream stream;
  for (const std::string& line : lines) stream << line << '\n';
  std::string text;
  int number = 1;
  if (!acquisition::take_line(stream, text) ||
      !complete_include(stream, text, number) ||
      number != static_cast<int>(lines.size())) {
    return std::nullopt;
  }
  return keywords ? included_by_keyword(text) : include_name(text);
}

// An INCLUDE that leads to the file asked for.
std::optional<std::vector<std::string>> renamed(const EditedLayout& layout,
                                                std::size_t asks,
                                                const FileAsked& asked,
                                                const std::string& old) {
  for (const std::string& name : names_for(layout, asks, asked)) {
    const bool keywords = layout.source.keywords;
    std::vector<std::string> lines = renamed_include(old, name, keywords);
    const std::optional<std::string> read = name_read(lines, keywords);
    if (read && layout.places.leads(asks, *read, asked.file)) return lines;
  }
  return std::nullopt;
}

// The INCLUDE as it was read: a comment that holds it.
std::string include_of(const std::string& line) {
  const std::size_t at = line.find("inlined: ");
  return line.substr(at + std::string_view("inlined: ").size());
}

}  // namespace

std::optional<std::string> file_text(const EditedLayout& layout,
                                     std::size_t k) {
  const EditedFile& file = layout.files[k];
  const WrittenLines original(file.original);
  TextWriter writer(original.usual_end());
  for (const std::size_t line : file.lines) {
    const LineOrigin& at = layout.source.origins[line];
    const std::string_view written = original.lines(at);
    const auto ask = file.asks.find(line);
    const auto other = layout.edited.replaced.find(line);
    if (other != layout.edited.replaced.end()) {
      writer.add(other->second, original.end(at));
    } else if (ask == file.asks.end() ||
               layout.places.leads(k, ask->second.name, ask->second.file)) {
      writer.as_written(written);
    } else {
      const auto lines = renamed(
          layout, k, ask->second, include_of(layout.source.lines[line].text));
      if (!lines) return std::nullopt;
      writer.add(*lines, original.end(at));
    }
  }
  if (k == 0) writer.add(layout.edited.behind, writer.usual());
  return std::move(writer.text());
}

}  // namespace tapfit::structure
