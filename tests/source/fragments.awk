# SPDX-License-Identifier: GPL-3.0-or-later
# Comments on lines of their own that begin with a word of which clauses and
# phrases begin ("What", "Of", "Where" ...) and whose first sentence has no main
# verb, as best a script can tell: a sentence has to have more finite verbs than
# words that begin a clause.  Prints them with their places.
function judge(first, count, k, words, verbs, clauses, before, word) {
    sub(/^[ *]+/, "", text)
    if (match(text, /([^A-Z]\.|[:;])( |$)/)) {
        if (substr(text, RSTART + 1, 1) == ".") RSTART++
        text = substr(text, 1, RSTART)
    }
    count = split(text, words, /[ ,.:;()]+/)
    first = words[1]
    if (!(first in opens)) return
    for (k = 1; k <= count; k++) {
        word = tolower(words[k])
        if (word in clause) clauses++
        else if (word in verb && !(before in joins)) verbs++
        before = word
    }
    if (verbs > clauses && !(first in always)) return
    print FILENAME ":" line ": " text
}
function set(list, into, words, k, count) {
    count = split(list, words, " ")
    for (k = 1; k <= count; k++) into[words[k]] = 1
}
BEGIN {
    set("What Of Whether How Where By From As So In At With On For After", opens)
    set("Before Between That Which When If Because Without Under Over", opens)
    set("Within Along Across To Like Instead Beside Until Since Per", opens)
    set("Against Into Among Around Above Below Beyond During Through", opens)
    set("Whether How Which", always) # no sentence begins so here
    set("what whether how where which that when if because until", clause)
    set("unless while who whose whatever wherever whom since", clause)
    set("and or but nor", joins)
    set("is are was were has had does did can cannot could", verb)
    set("must may might will would shall should isn't", verb)
    set("takes stands says goes leaves begins lies comes", verb)
    set("makes holds gives carries keeps needs follows writes arrives", verb)
    set("falls becomes wants adds yields asks belongs fails grows", verb)
    set("fills reaches varies rises lacks meets links opens", verb)
    set("depends puts finds brings bears expands leads reverses", verb)
    set("solves gets knows tells", verb)
    set("drives decides builds frees checks travels tries", verb)
    set("resolves appears allows breaks enters covers defines happens", verb)
    set("speaks dies serves leans likes stays returns", verb)
    set("sees differs overlaps vanishes", verb)
    set("describes replaces exists divides holds agrees tends", verb)
    set("equals contains includes prints", verb)
    set("converges refuses calls closes replays repeats feels", verb)
    set("matter", verb)
}
FNR == 1 { inside = 0; slashes = 0 }
slashes && !/^ *\/\// { judge(); slashes = 0 }
inside {
    end = index($0, "*/")
    text = text " " (end ? substr($0, 1, end - 1) : $0)
    sub(/ \*? */, " ", text)
    if ($0 ~ /^ *\*?[ ]*$/) text = text ". "
    gsub(/ +\*? +/, " ", text)
    if (end) { inside = 0; judge() }
    next
}
/^ *\/\// {
    if (!slashes) { line = FNR; text = "" }
    slashes = 1
    sub(/^ *\/\/ */, "")
    text = text " " $0
    next
}
/^ *\/\*/ {
    line = FNR
    text = $0
    sub(/^ *\/\*+/, "", text)
    end = index(text, "*/")
    if (end) { text = substr(text, 1, end - 1); judge() }
    else inside = 1
}
