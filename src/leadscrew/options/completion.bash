# Completion of @NAME@ for bash, as `@NAME@ completion bash` prints it.

# Adds the words that begin with what has been typed.
_@NAME@_words() {
  local word
  for word in "$@"; do [[ $word == "$current"* ]] && COMPREPLY+=("$word"); done
}

# The same for the last of several words with commas between them.
_@NAME@_list() {
  local word before=
  [[ $current == *,* ]] && before=${current%,*},
  for word in "$@"; do [[ $before$word == "$current"* ]] && COMPREPLY+=("$before$word"); done
}

# Adds folders and, of files, those with one of the endings; all where none is given, or where there would be nothing.
_@NAME@_files() {
  local name ending
  local -a all=() chosen=()
  while IFS= read -r name; do
    all+=("$name")
    if [[ -d $name || $# == 0 ]]; then
      chosen+=("$name")
      continue
    fi
    for ending in "$@"; do [[ ${name,,} == *"$ending" ]] && chosen+=("$name"); done
  done < <(compgen -f -- "$current")
  if ((${#chosen[@]})); then COMPREPLY+=("${chosen[@]}"); else COMPREPLY+=("${all[@]}"); fi
  compopt -o filenames 2>/dev/null
}

_@NAME@_folders() {
  local name
  while IFS= read -r name; do COMPREPLY+=("$name"); done < <(compgen -d -- "$current")
  compopt -o filenames 2>/dev/null
}

_@NAME@() {
  local current previous command options= takes= part joins= i
  local -a words=()
  COMPREPLY=()
  # Readline parts words at = and : too.
  for ((i = 1; i <= COMP_CWORD; ++i)); do
    part=${COMP_WORDS[i]}
    if [[ $part == = ]]; then
      ((i == COMP_CWORD)) && words+=("")
    elif [[ ($part == : || $joins) && ${#words[@]} -gt 0 ]]; then
      words[-1]+=$part
      [[ $part == : ]] && joins=1 || joins=
    else
      words+=("$part")
    fi
  done
  current=${words[-1]}
  command=${words[0]}
  if ((${#words[@]} == 1)); then
    _@NAME@_words @COMMANDS@
    return
  fi
  previous=${words[-2]}
  case $command in
@OPTIONS@
  esac
  if [[ $current == -* ]]; then
    _@NAME@_words $options
    return
  fi
  # Which of the words that are no options is being typed?
  local place=0 value=
  for part in "${words[@]:1:${#words[@]}-2}"; do
    if [[ $value ]]; then
      value=
    elif [[ $part == -?* ]]; then
      [[ " $takes " == *" $part "* ]] && value=1
    else
      ((++place))
    fi
  done
  case "$command $place" in
@WORDS@
  esac
  # What stands before a colon is no part of the word that readline replaces.
  if [[ $current == *:* && $COMP_WORDBREAKS == *:* ]]; then
    COMPREPLY=("${COMPREPLY[@]#"${current%"${current##*:}"}"}")
  fi
}

complete -F _@NAME@ @NAME@
