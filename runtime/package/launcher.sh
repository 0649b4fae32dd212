#!/bin/sh
# Starts plsc with the C library and the others that lie in lib/plsc, whatever
# those of this machine are. May be called through links.
case $0 in
  */*) here=$0 ;;
  *) here=$(command -v -- "$0") ;;
esac
here=$(readlink -f -- "$here") || exit 127
folder=${here%/bin/*}/lib/plsc

# What the environment adds to programs is for this machine's C library.
unset LD_PRELOAD LD_AUDIT
for loader in "$folder"/ld-linux*; do
  exec "$loader" --inhibit-cache --library-path "$folder" "$folder/plsc" "$@"
done
