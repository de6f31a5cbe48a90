# Completes the command line of evbal in bash: evbal itself says what a word may become, files are left to the shell.
_evbal() {
  mapfile -t COMPREPLY < <("$1" complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}
complete -o default -F _evbal evbal
