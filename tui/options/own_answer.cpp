#include "tui/options/own_answer.hpp"

#include "tui/options/help_format.hpp"
#include "tui/options/misspelt.hpp"
#include "tui/options/standard_streams.hpp"

#include <memory>
#include <sstream>

namespace tapfit::tui {
namespace {

int answer(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream out;
  std::ostringstream err;
  if (app.exit(error, out, err) != 0) {
    say(err.str() + meant_words(app));
    return 2;
  }
  print(out.str());
  return 0;
}

}  // namespace

std::optional<int> answered(CLI::App& app,
                            int argc,
                            const char* const* argv,
                            const std::function<void()>& check) {
  app.formatter(std::make_shared<HelpFormat>());
  const std::string name = app.get_name();
  const std::string footer = app.get_footer();
  app.footer(footer + (footer.empty() ? "" : "\n\n") +
             example_of(name.substr(name.rfind(' ') + 1)));
  try {
    app.parse(argc, argv);
    if (check) check();
  } catch (const CLI::ParseError& error) {
    return answer(app, error);
  }
  return std::nullopt;
}

}  // namespace tapfit::tui
