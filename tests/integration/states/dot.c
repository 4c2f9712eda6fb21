/* Prints the state machine's table as Graphviz text; the picture in docs is made from it:
 *   build/dev/bin/exk-states-dot > docs/img/states.dot
 *   dot -Tsvg -o docs/img/states.svg docs/img/states.dot                                        */
#include <stdio.h>

#include "exk/state.h"

static const char *color_of(exk_cause cause)
{
    switch (cause) {
    case EXK_CAUSE_START:
    case EXK_CAUSE_STOP:
    case EXK_CAUSE_ABORT:
    case EXK_CAUSE_CLEAR:
    case EXK_CAUSE_QUIT:
        return "#1f5fa8"; /* asked for */
    case EXK_CAUSE_TIMEOUT:
    case EXK_CAUSE_SENSOR:
    case EXK_CAUSE_LIMIT:
    case EXK_CAUSE_OVERRUN:
    case EXK_CAUSE_SOURCE:
        return "#b03a2e"; /* went wrong */
    case EXK_CAUSE_NONE:
    case EXK_CAUSE_READY:
    case EXK_CAUSE_END:
    case EXK_CAUSE_COUNT:
        break;
    }
    return "#404040"; /* of itself */
}

/* One arrow for all events that lead from one state to another, one line an event. */
static void print_arrow(exk_state from, exk_state to)
{
    const exk_transition *table;
    const size_t n = exk_state_transitions(&table);
    bool open = false;
    for (size_t i = 0; i < n; i++) {
        if (table[i].from != from || table[i].to != to) {
            continue;
        }
        if (!open) {
            printf("    %s -> %s [label=<<table border=\"0\" cellspacing=\"0\">",
                   exk_state_name(from), exk_state_name(to));
        }
        open = true;
        printf("<tr><td><font color=\"%s\">%s</font></td></tr>", color_of(table[i].cause),
               exk_cause_name(table[i].cause));
    }
    printf("%s", open ? "</table>>];\n" : "");
}

int main(void)
{
    puts("digraph states {\n"
         "    rankdir=LR;\n"
         "    node [shape=box, style=rounded, fontname=\"sans-serif\"];\n"
         "    edge [fontname=\"sans-serif\", fontsize=10];");
    for (int from = 0; from < EXK_STATE_COUNT; from++) {
        for (int to = 0; to < EXK_STATE_COUNT; to++) {
            print_arrow((exk_state)from, (exk_state)to);
        }
    }
    puts("}");
    return 0;
}
