# Completion of @NAME@ for fish, as `@NAME@ completion fish` prints it.

# Is this the command of the line? Without an argument: is there none yet?
function __@NAME@_is
    set -l words (commandline -opc)
    if test (count $argv) -eq 0
        test (count $words) -lt 2
    else
        test (count $words) -ge 2; and test $words[2] = $argv[1]
    end
end

# Is the word that is being typed at this place among those that are no options? Behind it: the options that take values.
function __@NAME@_at
    set -l words (commandline -opc)
    set -l place 0
    set -l value 0
    for word in $words[3..-1]
        if test $value -eq 1
            set value 0
        else if string match -q -- '-?*' $word
            contains -- $word $argv[2..-1]; and set value 1
        else
            set place (math $place + 1)
        end
    end
    test $value -eq 0; and test $place -eq $argv[1]
end

# Folders and, of files, those with one of the endings; all where none is given, or where there would be nothing.
function __@NAME@_files
    set -l typed (commandline -ct | string replace -r -- '^--[^=]*=' '')
    set -l all (__fish_complete_path $typed)
    set -l chosen $all
    if test (count $argv) -gt 0
        set -l endings (string join '|' -- (string escape --style=regex -- $argv))
        set chosen (string match -ri -- '^.*(?:/|'$endings')(?:\t.*)?$' $all)
    end
    test (count $chosen) -gt 0; or set chosen $all
    test (count $chosen) -gt 0; and printf '%s\n' $chosen
end

# One more of the words behind those that stand there, with commas between them.
function __@NAME@_list
    set -l before (commandline -ct | string replace -r -- '^--[^=]*=' '' | string match -r -- '^.*,')
    printf '%s\n' "$before"$argv
end

complete -c @NAME@ -f
@COMPLETIONS@
