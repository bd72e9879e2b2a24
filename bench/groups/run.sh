#!/bin/sh
# run.sh PROGRAM FOLDER: makes the rooms of wishes.json (seed 1) into FOLDER and judges them.
set -eu
here=$(dirname "$0")
mkdir -p "$2"
python3 -c "import json,sys; [print(w['id'], w['wish'], sep='\t') for w in json.load(open(sys.argv[1]))]" "$here/wishes.json" |
while IFS="$(printf '\t')" read -r id wish; do
  "$1" generate "$wish" -o "$2/$id" --force --seed 1 --quiet < /dev/null || echo "wish $id made no room" >&2
done
python3 "$here/judge.py" "$2" "$here/wishes.json"
