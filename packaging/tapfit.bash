# Completion of tapfit for bash: commands, then their options, then files.
_tapfit() {
  local current=${COMP_WORDS[COMP_CWORD]}
  local commands="run hits frf check calibrate replay modes mac model uff
    compare diagnose signature update predict together session report export import
    paper tour doctor simulate challenge reveal score"
  local command= word
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case " ${commands//$'\n'/ } " in
      *" $word "*) command=$word; break ;;
    esac
  done
  COMPREPLY=()
  if [[ $current == -* ]]; then
    # Each command lists its own options.
    local options
    options=$("${COMP_WORDS[0]}" $command --help 2>/dev/null |
      grep -oE -- '(^|[ ,])--?[a-z][a-z-]*' | tr -d ' ,' | sort -u)
    COMPREPLY=($(compgen -W "$options" -- "$current"))
    return
  fi
  [[ -n $command ]] || COMPREPLY=($(compgen -W "$commands" -- "$current"))
  COMPREPLY+=($(compgen -f -- "$current"))
  compopt -o filenames 2>/dev/null
}
complete -F _tapfit tapfit
