/** Command line of exk-doctor. */
#ifndef EXK_DOCTOR_OPTIONS_H
#define EXK_DOCTOR_OPTIONS_H

typedef struct {
    const char *url;       /* NULL: LCM_DEFAULT_URL, then the profile's default */
    const char *json_path; /* NULL: lines for people; "-": standard output */
} doctor_options;

/** Exits with 2 and a message on wrong use. */
void doctor_options_parse(int argc, char **argv, doctor_options *out);

#endif
