#compdef @NAME@
# Completion of @NAME@ for zsh, as `@NAME@ completion zsh` prints it.

# Files with one of the endings in the first argument, all where it is empty; and the words behind it.
_@NAME@_files() {
  local endings=$1
  shift
  (( $# )) && compadd -- "$@"
  if [[ -n $endings ]]; then
    # The qualifiers at the end: one ending alone would be taken for such.
    _files -g "*.(#i)($endings)(-.)"
  else
    _files
  fi
}

_@NAME@() {
  local curcontext="$curcontext" state line
  typeset -A opt_args
  local -a commands=(
@COMMANDS@
  )
  _arguments -C \
@ITSELF@
    '1: :->command' \
    '*:: :->rest' && return
  case $state in
  command) _describe command commands ;;
  rest)
    case $words[1] in
@ARGUMENTS@
    esac
    ;;
  esac
}

# In a folder of functions it is called; sourced, it is made known.
if [[ $funcstack[1] == _@NAME@ ]]; then
  _@NAME@ "$@"
else
  compdef _@NAME@ @NAME@
fi
