/* c_locale.h: inside lib/base only. printf and strtod follow the locale that some library may have
 * set: number text is made and read under a "C" locale of our own, which is switched on for the
 * calling thread alone. */
#ifndef BASE_C_LOCALE_H
#define BASE_C_LOCALE_H

#include <locale.h>

locale_t base_enter_c_locale(void);
void base_leave_c_locale(locale_t before);

#endif
