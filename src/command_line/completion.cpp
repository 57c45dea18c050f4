// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/completion.hpp"

#include <fmt/format.h>

namespace torquewright::command_line {
namespace {

std::string command_names(const DeclaredCommand& command) {
  std::string words;
  for (const DeclaredCommand& each : command.commands) words += " " + each.name;
  return words.empty() ? words : words.substr(1);
}

std::string option_names(const DeclaredCommand& command, bool only_with_value) {
  std::string words;
  for (const DeclaredOption& option : command.options) {
    if (option.is_argument || (only_with_value && option.value.empty())) continue;
    for (const std::string& name : option.names) words += " " + name;
  }
  return words.empty() ? words : words.substr(1);
}

std::string choices(const DeclaredOption& option) {
  return fmt::format("{}", fmt::join(option.choices, " "));
}

/// A text in single quotes, as shells take it.
std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char letter : text) {
    safe += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return safe + "'";
}

/// Branches of `case` over "COMMAND" and over "COMMAND OPTION": what follows there.
struct Cases {
  std::string commands, options, takers, words, arguments;
};

Cases cases_of(const DeclaredCommand& program) {
  Cases cases;
  for_each_command(program, [&](const DeclaredCommand& command, const std::string& path) {
    const auto branch = [](const std::string& key, const std::string& words) {
      return fmt::format("    {}) echo {} ;;\n", quoted(key), quoted(words));
    };
    if (!command.commands.empty()) cases.commands += branch(path, command_names(command));
    cases.options += branch(path, option_names(command, false));
    cases.takers += branch(path, option_names(command, true));
    for (const DeclaredOption& option : command.options) {
      if (option.choices.empty()) continue;
      if (option.is_argument) cases.arguments += branch(path, choices(option));
      for (const std::string& name : option.names) {
        if (!option.is_argument) cases.words += branch(path + " " + name, choices(option));
      }
    }
  });
  return cases;
}

std::string shell_function(const std::string& name, const std::string& branches) {
  return fmt::format("_torquewright_{}() {{\n  case \"$1\" in\n{}  esac\n}}\n\n", name, branches);
}

/// What bash and zsh share: questions about the declarations.
std::string shell_functions(const DeclaredCommand& program) {
  const Cases cases = cases_of(program);
  return shell_function("commands", cases.commands) + shell_function("options", cases.options) +
         shell_function("takers", cases.takers) + shell_function("words", cases.words) +
         shell_function("arguments", cases.arguments);
}

/// Sets `candidates` for the words so far, of which the last is the one to be completed; empty:
/// files. For bash, and for zsh with its options emulating sh.
constexpr std::string_view kCandidates = R"sh(_torquewright_candidates() {
  local command='' previous='' last='' word known before=':'
  for last in "$@"; do :; done
  while [ $# -gt 1 ]; do
    word=$1
    shift
    known=" $(_torquewright_commands "$command") "
    case "$word" in
      -*) ;;
      *)
        case " $(_torquewright_takers "$command") " in
          *" $before "*) ;;
          *) case "$known" in *" $word "*) command=${command:+$command }$word ;; esac ;;
        esac ;;
    esac
    before=$word
  done
  previous=$before
  candidates=''
  case "$last" in
    -*)
      candidates=$(_torquewright_options "$command")
      return ;;
  esac
  case " $(_torquewright_takers "$command") " in
    *" $previous "*)
      candidates=$(_torquewright_words "$command $previous")
      candidates=${candidates:-$(_torquewright_words "${previous}")}
      return ;;
  esac
  candidates=$(_torquewright_commands "$command")
  candidates=${candidates:-$(_torquewright_arguments "$command")}
}

)sh";

}  // namespace

std::string bash_completion(const DeclaredCommand& program) {
  std::string script = fmt::format("# bash completion for {}\n\n", program.name);
  script += shell_functions(program);
  script += kCandidates;
  script += R"sh(_torquewright() {
  local candidates current=${COMP_WORDS[COMP_CWORD]}
  _torquewright_candidates "${COMP_WORDS[@]:1:COMP_CWORD}"
  if [ -n "$candidates" ]; then
    COMPREPLY=($(compgen -W "$candidates" -- "$current"))
  else
    COMPREPLY=()
    compopt -o default 2> /dev/null
  fi
}

)sh";
  return script + fmt::format("complete -F _torquewright {}\n", program.name);
}

std::string zsh_completion(const DeclaredCommand& program) {
  std::string script = fmt::format("#compdef {}\n\n", program.name);
  script += shell_functions(program);
  script += kCandidates;
  return script + R"sh(_torquewright() {
  local candidates
  _torquewright_candidates "${(@)words[2,CURRENT]}"
  if [[ -n "$candidates" ]]; then
    compadd -- ${=candidates}
  else
    _files
  fi
}

if [ "$funcstack[1]" = "_torquewright" ]; then
  _torquewright "$@"
else
  compdef _torquewright )sh" +
         program.name + "\nfi\n";
}

namespace {

/// `__fish_seen_subcommand_from` knows one level only: ours asks for the exact words.
constexpr std::string_view kFishCommand = R"sh(function __torquewright_at
  set -l command
  for word in (commandline -opc)[2..-1]
    string match -q -- '-*' $word; and break
    contains -- "$command $word" $__torquewright_commands; or break
    set command "$command $word"
  end
  test "$command" = "$argv[1]"
end

)sh";

std::string fish_option(const DeclaredOption& option) {
  std::string text;
  for (const std::string& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (!option.value.empty()) text += " -r";
  if (!option.choices.empty()) text += " -f -a " + quoted(choices(option));
  return text + " -d " + quoted(option.help);
}

}  // namespace

std::string fish_completion(const DeclaredCommand& program) {
  std::string names, lines;
  for_each_command(program, [&](const DeclaredCommand& command, const std::string& path) {
    const std::string key = path.empty() ? "" : " " + path;
    if (!key.empty()) names += " " + quoted(key);
    const std::string at =
        fmt::format("complete -c {} -n '__torquewright_at \"{}\"'", program.name, key);
    for (const DeclaredCommand& each : command.commands) {
      lines += fmt::format("{} -f -a {} -d {}\n", at, each.name, quoted(each.help));
    }
    for (const DeclaredOption& option : command.options) {
      if (!option.is_argument) lines += at + fish_option(option) + "\n";
      if (option.is_argument && !option.choices.empty()) {
        lines += fmt::format("{} -f -a {}\n", at, quoted(choices(option)));
      }
    }
  });
  return fmt::format("# fish completion for {}\n\nset -g __torquewright_commands{}\n\n",
                     program.name, names) +
         std::string(kFishCommand) + lines;
}

}  // namespace torquewright::command_line
