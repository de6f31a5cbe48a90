#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace evbal {

/// What the last of `words` may become: the name of a command or an option, or of something that is shipped. `words`
/// are those that follow the name of `app` on a command line, as bash parts them: `=` is a word of its own. A value
/// after `=` is given without the option's name. Empty where a file or free text is expected.
std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace evbal
