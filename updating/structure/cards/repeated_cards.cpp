#include "updating/structure/cards/repeated_cards.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace tapfit::structure {
namespace {

using Fields = std::vector<std::string>;

constexpr std::size_t line_fields = 8;
constexpr int most_repetitions = 1'000'000;

// The x of "*x" and "*(x)"; likewise the n of "=n" and "=(n)".
std::optional<std::string> behind_sign(const std::string& field, char sign) {
  if (field.size() < 2 || field.front() != sign || field == "==") {
    return std::nullopt;
  }
  if (field[1] != '(') return field.substr(1);
  if (field.back() != ')') return std::nullopt;
  return field.substr(2, field.size() - 3);
}

bool repeats(const Card& card) {
  return card.name().starts_with("=") ||
         std::ranges::any_of(card.fields, [](const std::string& field) {
           return field == "=" || field == "==" || behind_sign(field, '*');
         });
}

InputError no_repetition(const Card& card, const std::string& what) {
  return {fmt::format("{} cannot be repeated: {}", card.name(), what),
          card.where,
          "\"=\" stands for the field of the card before, \"*(1)\" for its "
          "number and 1 more, \"=(3)\" for three cards more; or write the "
          "cards out"};
}

std::string with_point(double value) {
  const std::string text = fmt::format("{:.12g}", value);
  return text.find_first_of(".en") == std::string::npos ? text + "." : text;
}

std::string stepped(const Card& card,
                    const std::string& from,
                    const std::string& step) {
  const auto whole = parse_integer(from);
  const auto whole_step = parse_integer(step);
  if (whole && whole_step) {
    return fmt::format("{}", static_cast<long>(*whole) + *whole_step);
  }
  const auto real = parse_real(from);
  const auto real_step = parse_real(step);
  if (!real || !real_step) {
    throw no_repetition(
        card,
        fmt::format("\"{}\" and \"{}\" are not both numbers", from, step));
  }
  return with_point(*real + *real_step);
}

// Whether nothing but blanks stands behind the field.
bool is_last(const Fields& fields, std::size_t at) {
  return std::all_of(fields.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                     fields.end(),
                     [](const std::string& field) { return field.empty(); });
}

// Steps of a card by field, empty where there is none.
struct Made {
  Card card;
  Fields steps;
};

std::string field_at(const Card& card, std::size_t k) {
  return k < card.fields.size() ? card.fields[k] : "";
}

Made made_of(const Card& written, const Card& before) {
  Made made{written, Fields(written.fields.size())};
  Fields& fields = made.card.fields;
  if (fields.front() == "=") {
    fields.front() = before.name();
  } else if (fields.front().starts_with("=")) {
    throw no_repetition(written, "that is no name of a repetition");
  }
  for (std::size_t k = 1; k < fields.size(); ++k) {
    if (fields[k] == "=") {
      fields[k] = field_at(before, k);
    } else if (fields[k] == "==") {
      const std::size_t end =
          is_last(fields, k)
              ? std::max(fields.size(), before.fields.size())
              : std::min(fields.size(),
                         1 + (k - 1) / line_fields * line_fields + line_fields);
      fields.resize(std::max(fields.size(), end));
      for (; k < end; ++k) fields[k] = field_at(before, k);
      --k;
    } else if (const auto step = behind_sign(fields[k], '*')) {
      fields[k] = stepped(made.card, field_at(before, k), *step);
      made.steps[k] = *step;
    }
  }
  made.card.repeated = true;
  return made;
}

// @param made how many were repeated so far
int count_of(const Card& card, const std::string& text, int made) {
  if (!is_last(card.fields, 0)) {
    throw no_repetition(card, "fields behind a number of cards mean nothing");
  }
  const auto count = parse_integer(text);
  if (count && *count > 0 && *count <= most_repetitions - made) return *count;
  throw no_repetition(card,
                      fmt::format("\"{}\" is no number of cards, 1 to {}",
                                  card.name(),
                                  most_repetitions - made));
}

}  // namespace

std::vector<Card> written_out(std::vector<Card> cards) {
  if (std::ranges::none_of(cards, repeats)) return cards;
  std::vector<Card> all;
  Fields steps;  // of the last card
  int counted = 0;
  for (Card& card : cards) {
    if (!repeats(card)) {
      all.push_back(std::move(card));
      steps.clear();
      continue;
    }
    if (all.empty()) throw no_repetition(card, "no card stands before it");
    const auto count = behind_sign(card.name(), '=');
    if (!count) {
      Made made = made_of(card, all.back());
      all.push_back(std::move(made.card));
      steps = std::move(made.steps);
      continue;
    }
    int left = count_of(card, *count, counted);
    counted += left;
    for (; left > 0; --left) {
      Card next = all.back();
      next.where = card.where;
      next.line = card.line;
      next.lines = card.lines;
      next.repeated = true;
      for (std::size_t k = 0; k < steps.size(); ++k) {
        if (steps[k].empty()) continue;
        next.fields[k] = stepped(next, next.fields[k], steps[k]);
      }
      all.push_back(std::move(next));
    }
  }
  return all;
}

}  // namespace tapfit::structure
