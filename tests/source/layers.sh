#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A file includes headers of its own layer and of lower layers, never in
# circles. Of a folder inside a layer, only the header with the folder's name is
# included from outside, if it exists. The command line includes only
# overroll/*.h of the library. In folders of a subject (elements, physics),
# LAYER_NAME belongs to that layer. No file above multigrid contains a grid with
# one mesh size.
set -u
cd "$TOP" || exit 1
floors="base mathematics contact elements surface multigrid strip stress
    simulation results case physics run pictures cli web"

# "file included" for every #include "..." of the project.
find src include -name '*.[ch]' -exec grep -HE '^ *# *include *"' {} + |
    sed 's/^\([^:]*\):[^"]*"\([^"]*\)".*/\1 \2/' >"$OLDPWD/pairs"
find src -name '*.[ch]' ! -path 'src/multigrid/*' ! -path 'src/strip/*' \
    -exec grep -HnE 'grid(\.|->)D\>' {} + | grep . && exit 1
cd "$OLDPWD" || exit 1

faces=$(cd "$TOP/src" && ls ./*/*/*.h | sed 's/^..//' | tr '\n' ' ')
awk -v floors="$floors" -v faces=" $faces" '
    # FLOOR/NAME of FLOOR_NAME in the folder of a subject.
    function above(name) {
        if (name ~ /^(elements|physics\/[a-z]+)\/(case|run|pictures)_/) {
            sub(/^.*\//, "", name)
            sub(/_/, "/", name)
        }
        return name
    }
    # The number of the floor that a file or an included name stands on.
    function floor(name,    part, base) {
        sub(/^src\//, "", name)
        sub(/^include\//, "", name)
        name = above(name)
        split(name, part, "/")
        if (part[1] != "overroll")
            return height[part[1]]
        base = part[2]
        sub(/\.h$/, "", base)
        return height[base in home ? home[base] : base]
    }
    # FLOOR/FOLDER/ of a header that is not the face its folder has.
    function inside(name,    part, home) {
        if (split(above(name), part, "/") != 3 || part[3] == part[2] ".h")
            return ""
        home = part[1] "/" part[2] "/"
        return index(faces, " " home part[2] ".h ") ? home : ""
    }
    BEGIN {
        n = split(floors, name)
        for (i = 1; i <= n; i++)
            height[name[i]] = i
        # Public headers that are not named after their floor.
        home["error"] = home["memory"] = home["version"] = home["text"] = "base"
        home["oil"] = home["heat"] = "contact"
        home["profile"] = "surface"
        home["areal"] = "surface"
        home["conflicts"] = "simulation"
        home["questions"] = "run"
        home["overroll"] = "cli"
    }
    !floor($1) { print $1 ": on no floor that this test knows"; bad = 1 }
    !floor($2) { print $1 ": includes " $2 ", on no known floor"; bad = 1 }
    inside($2) && !($1 ~ "^src/" inside($2)) {
        print $1 ": includes " $2 ", an inside"; bad = 1 }
    $1 ~ /^src\/cli\// && $2 !~ /^(cli|overroll)\// {
        print $1 " includes " $2 ", no header of the library for programs"
        bad = 1
    }
    floor($1) < floor($2) { print $1 " includes " $2 " from above"; bad = 1 }
    END { exit bad }' pairs || exit 1

sed 's/^src\///; s/^include\///' pairs | tsort >/dev/null 2>circles || {
    cat circles
    exit 1
}
