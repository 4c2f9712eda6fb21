/** Changes one value of a profile and nothing else: comments and order stay. An exit code. */
#ifndef STUDY_INI_EDIT_H
#define STUDY_INI_EDIT_H

int study_ini_set(const char *path, const char *section, const char *key, const char *value);

#endif
