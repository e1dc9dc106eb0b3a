# Writes a man page: awk -v program=PATH -v version=V -v date=D -f man_page.awk PAGE.in
#
# The page's own text is in PAGE.in. Commands and options come from the program's --help, so that
# they stand in one place, the program's source:
#   @VERSION@, @DATE@, @DOCDIR@   the values given
#   @SYNOPSIS@           how the program and each of its commands are called
#   @OPTIONS@            the options of the program itself
#   @COMMANDS@           a section for each command; an option that an earlier command describes in
#                        the same words is only named

function fail(text) {
    print "man_page.awk: " text > "/dev/stderr"
    failed = 1
    exit 1
}

# Text as roff prints it as it stands.
function roff(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    return text ~ /^[.']/ ? "\\&" text : text
}

# Fills help[1..lines] with `PROGRAM [COMMAND] --help`.
function read_help(command,    line, call) {
    split("", help)
    lines = 0
    call = "'" program "' " command " --help"
    while ((call | getline line) > 0) help[++lines] = line
    if (close(call) != 0 || lines == 0) fail("this fails: " call)
}

# The usage line of the help, without the program's options.
function usage(    i, line) {
    for (i = 1; i <= lines && help[i] !~ /^Usage: /; ++i) {}
    line = substr(help[i], 8)
    sub(/ SUBCOMMAND$/, " COMMAND", line)
    return line
}

function bold_name(line,    words, count, i, text, depth) {
    count = split(line, words, " ")
    depth = words[2] ~ /^[a-z]/ ? 2 : 1
    text = "\\fB" roff(words[1]) (depth == 2 ? " " roff(words[2]) : "") "\\fR"
    for (i = depth + 1; i <= count; ++i) text = text " \\fI" roff(words[i]) "\\fR"
    return text
}

# "-o,--output FILE REQUIRED Excludes: --x" becomes the head of an entry and, in `notes`, sentences.
function head(signature,    parts, names, count, i, text, value) {
    notes = ""
    if (signature ~ / REQUIRED/) notes = notes " Required."
    sub(/ REQUIRED/, "", signature)
    if (match(signature, / Needs: .*/)) {
        notes = notes " Needs " substr(signature, RSTART + 8) "."
        signature = substr(signature, 1, RSTART - 1)
    }
    if (match(signature, / Excludes: .*/)) {
        value = substr(signature, RSTART + 11)
        gsub(/ /, ", ", value)
        notes = notes " Not together with " value "."
        signature = substr(signature, 1, RSTART - 1)
    }
    value = ""
    if (match(signature, / .*/)) {
        value = substr(signature, RSTART + 1)
        signature = substr(signature, 1, RSTART - 1)
    }
    count = split(signature, names, ",")
    for (i = 1; i <= count; ++i) {
        text = text (i > 1 ? ", " : "") (names[i] ~ /^-/ ? "\\fB" : "\\fI") roff(names[i]) "\\fR"
    }
    return text (value == "" ? "" : " \\fI" roff(value) "\\fR")
}

function option_name(signature,    names, count) {
    sub(/ .*/, "", signature)
    count = split(signature, names, ",")
    return names[count]
}

# Prints the entries of "Positionals:" and "Options:" in help[].
function print_options(command,    i, inside, signature, text, key, shown, shared, order, owners) {
    owners = 0
    for (i = 1; i <= lines; ++i) {
        if (help[i] ~ /^(Positionals|Options):$/) inside = 1
        else if (help[i] == "") inside = 0
        else if (inside && help[i] ~ /^  [^ ]/) {
            # A long signature has its text on the next line, from the column of all texts on.
            if (i < lines && help[i + 1] ~ /^                              [^ ]/) {
                signature = substr(help[i], 3)
                text = substr(help[++i], 31)
            } else {
                signature = substr(help[i], 3, 28)
                text = substr(help[i], 31)
            }
            sub(/ +$/, "", signature)
            if (signature == "-h,--help" && command != "") continue
            key = signature "\n" text
            if (signature ~ /^-/ && key in described) {
                if (!(described[key] in shared)) order[++owners] = described[key]
                shared[described[key]] = shared[described[key]] ", \\fB" \
                    roff(option_name(signature)) "\\fR"
                continue
            }
            described[key] = command
            print ".TP"
            print head(signature)
            sub(/\.$/, "", text)
            print roff(text "." notes)
        }
    }
    for (i = 1; i <= owners; ++i) {
        print ".PP"
        print "As \\fB" roff(order[i]) "\\fR: " substr(shared[order[i]], 3)
    }
}

# Fills commands[1..command_count] from the program's help.
function find_commands(    i, inside) {
    read_help("")
    command_count = 0
    for (i = 1; i <= lines; ++i) {
        if (help[i] ~ /^Subcommands:$/) inside = 1
        else if (help[i] == "") inside = 0
        else if (inside && match(help[i], /^  [a-z][-a-z]*/)) {
            commands[++command_count] = substr(help[i], 3, RLENGTH - 2)
        }
    }
}

function print_synopsis(    i) {
    find_commands()
    print bold_name(usage())
    for (i = 1; i <= command_count; ++i) {
        read_help(commands[i])
        print ".br"
        print bold_name(usage())
    }
}

function print_commands(    i) {
    find_commands()
    if (command_count == 0) fail("no commands in the help of " program)
    for (i = 1; i <= command_count; ++i) {
        read_help(commands[i])
        print ".SS " roff(commands[i])
        print bold_name(usage())
        print ".PP"
        print roff(help[1]) "."
        print_options(commands[i])
    }
}

/^@SYNOPSIS@$/ { print_synopsis(); next }
/^@OPTIONS@$/ { read_help(""); print_options(""); next }
/^@COMMANDS@$/ { print_commands(); next }
{
    gsub(/@VERSION@/, version)
    gsub(/@DATE@/, date)
    if (/@DOCDIR@/) gsub(/@DOCDIR@/, roff(docdir))
    print
}

END { exit failed }
