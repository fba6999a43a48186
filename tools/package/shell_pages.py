#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the manual page and the completions of bash, zsh and fish from what the program says of itself.

Usage: tools/package/shell_pages.py PROGRAM FOLDER
"""
import gzip
import json
import pathlib
import subprocess
import sys


def escape(text):
    """Plain words in roff."""
    return text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")


def write_man(told, version):
    number = version.split()[1]
    lines = [f'.TH TALUS 1 "" "talus {number}" "User Commands"', ".SH NAME", f"talus \\- {escape(told['meaning'].split(': ', 1)[-1])}", ".SH SYNOPSIS",
             ".B talus", ".I COMMAND", "[OPTIONS]", ".SH DESCRIPTION", escape(told["meaning"]) + ".",
             "A case file in TOML says what is calculated; \\fBtalus template\\fR prints one to begin with, and \\fBtalus manual\\fR lists every key.", ".SH COMMANDS"]
    for command in told["commands"]:
        lines += [f".SS talus {command['name']}", escape(command["meaning"]) + "."]
        for option in command["options"]:
            names = ", ".join(f"\\fB{escape(name)}\\fR" for name in option["names"] if name.startswith("-"))
            value = (" " if names else "") + f"\\fI{escape(option['value'])}\\fR" if option["value"] else ""
            lines += [".TP", names + value, escape(option["meaning"]) + "."]
    lines += [".SH EXIT STATUS", "0 success; 1 a defect of the program; 2 wrong input; 3 the folder of results exists or is in use; 4 unstable; 5 interrupted; "
              "6 results cannot be written; 7 not enough memory.", ".SH SEE ALSO", "The manual in /usr/share/doc/talus."]
    return "\n".join(lines) + "\n"


def write_bash(told):
    cases = []
    for command in told["commands"]:
        words = " ".join(name for option in command["options"] for name in option["names"] if name.startswith("-"))
        cases.append(f'    {command["name"]}) words="{words}" ;;')
    commands = " ".join(command["name"] for command in told["commands"])
    return f"""# Completion of talus for bash
_talus() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} words=
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "{commands} --help --version" -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{chr(10).join(cases)}
  esac
  case $word in
    -*) COMPREPLY=($(compgen -W "$words" -- "$word")) ;;
    *) COMPREPLY=($(compgen -f -- "$word")) ;;
  esac
}}
complete -o filenames -F _talus talus
"""


def quote(text):
    return text.replace("'", "'\\''").replace("[", "\\[").replace("]", "\\]").replace(":", "\\:")


def write_zsh(told):
    commands = "\n".join(f"    '{command['name']}:{quote(command['meaning'])}'" for command in told["commands"])
    cases = []
    for command in told["commands"]:
        entries = []
        for option in command["options"]:
            for name in option["names"]:
                if name.startswith("-"):
                    entries.append(f"'{name}[{quote(option['meaning'])}]{':value:_files' if option['value'] else ''}'")
        cases.append(f"    {command['name']}) _arguments {' '.join(entries)} '*:file:_files' ;;")
    return f"""#compdef talus
# Completion of talus for zsh
local -a commands
commands=(
{commands}
)
if (( CURRENT == 2 )); then
  _describe command commands
else
  local command=$words[2]
  shift words; (( CURRENT-- ))
  case $command in
{chr(10).join(cases)}
  esac
fi
"""


def write_fish(told):
    lines = ["# Completion of talus for fish"]
    for command in told["commands"]:
        meaning = command["meaning"].replace("'", "\\'")
        lines.append(f"complete -c talus -n __fish_use_subcommand -a {command['name']} -d '{meaning}'")
        for option in command["options"]:
            flags = "".join(f" -l {name[2:]}" if name.startswith("--") else f" -s {name[1:]}" for name in option["names"] if name.startswith("-"))
            if flags:
                meaning = option["meaning"].replace("'", "\\'")
                lines.append(f"complete -c talus -n '__fish_seen_subcommand_from {command['name']}'{flags}{' -r' if option['value'] else ''} -d '{meaning}'")
    return "\n".join(lines) + "\n"


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    told = json.loads(subprocess.run([program, "commands"], check=True, capture_output=True, text=True).stdout)
    version = subprocess.run([program, "version"], check=True, capture_output=True, text=True).stdout
    folder.mkdir(parents=True, exist_ok=True)
    with gzip.GzipFile(folder / "talus.1.gz", "wb", mtime=0) as page:
        page.write(write_man(told, version).encode())
    (folder / "talus").write_text(write_bash(told))
    (folder / "_talus").write_text(write_zsh(told))
    (folder / "talus.fish").write_text(write_fish(told))


if __name__ == "__main__":
    main()
