#include "studies/dda/shell/completion.hpp"

namespace dda {
namespace {

/// bash splits words at '=' and ':', and completes the last part alone.
constexpr const char* bash = R"(# bash completion of dda, printed by `dda completion bash`.
_dda() {
  local line=${COMP_LINE:0:COMP_POINT} current=${COMP_WORDS[COMP_CWORD]} words reply word kind
  read -ra words <<<"$line"
  [[ $line == *[[:space:]] ]] && words+=("")
  local typed=${words[-1]}
  [[ $current == = ]] && current=
  local before=${typed%"$current"}
  COMPREPLY=()
  while IFS=$'\t' read -r reply _; do
    case $reply in
      :deck)
        compopt -o filenames
        while IFS= read -r word; do COMPREPLY+=("$word"); done < <(compgen -d -- "$current"
          for kind in yaml yml json; do compgen -f -X "!*.$kind" -- "$current"; done)
        ;;
      :file)
        compopt -o filenames
        while IFS= read -r word; do COMPREPLY+=("$word"); done < <(compgen -f -- "$current")
        ;;
      :folder)
        compopt -o filenames
        while IFS= read -r word; do COMPREPLY+=("$word"); done < <(compgen -d -- "$current")
        ;;
      *) COMPREPLY+=("${reply#"$before"}") ;;
    esac
  done < <("${words[0]}" complete -- "${words[@]:1}" 2>/dev/null)
  [[ ${#COMPREPLY[@]} -gt 0 && ${COMPREPLY[0]} == *[.=] ]] && compopt -o nospace
  return 0
}
complete -F _dda dda
)";

constexpr const char* zsh = R"(#compdef dda
# zsh completion of dda, printed by `dda completion zsh`.
_dda() {
  local -a lines whole begun
  local line text
  lines=("${(@f)$("$words[1]" complete -- "${(@)words[2,CURRENT]}" 2>/dev/null)}")
  for line in $lines; do
    case $line in
      :deck) _files -g '*.(yaml|yml|json)(-.)' ;;
      :file) _files ;;
      :folder) _files -/ ;;
      *)
        text=${line%%$'\t'*}
        if [[ $text == *[.=] ]]; then begun+=("$text"); else whole+=("$text"); fi
        ;;
    esac
  done
  (( $#begun )) && compadd -S '' -a begun
  (( $#whole )) && compadd -a whole
  return 0
}
if [[ $funcstack[1] == _dda ]]; then _dda "$@"; else compdef _dda dda; fi
)";

constexpr const char* fish = R"(# fish completion of dda, printed by `dda completion fish`.
function __dda_complete
    set -l words (commandline -opc) (commandline -ct)
    for line in ($words[1] complete -- $words[2..] 2>/dev/null)
        switch $line
            case :deck
                __fish_complete_suffix .yaml
            case :file
                __fish_complete_path (commandline -ct)
            case :folder
                __fish_complete_directories (commandline -ct)
            case '*'
                echo $line
        end
    end
end
complete -c dda -f -a '(__dda_complete)'
)";

}  // namespace

std::vector<std::string> completion_shells() { return {"bash", "zsh", "fish"}; }

std::string completion_script(const std::string& shell) {
  if (shell == "bash") return bash;
  return shell == "zsh" ? zsh : fish;
}

}  // namespace dda
