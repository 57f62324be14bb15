/* lex.c: form texts to tokens. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "form.h"

static bool is_name_start(char c)
{
    return c == '_' || isalpha((unsigned char)c);
}
static bool is_name(char c)
{
    return c == '_' || isalnum((unsigned char)c);
}

/* Length of the number at text: digits, a point, an exponent, and any letters stuck to it, which
 * the check refuses. */
static size_t number_length(const char *text)
{
    size_t n = 0;
    while (
        is_name(text[n]) || text[n] == '.' ||
        ((text[n] == '+' || text[n] == '-') && n > 0 && (text[n - 1] == 'e' || text[n - 1] == 'E')))
        n++;
    return n;
}

static size_t sign_length(const char *text)
{
    static const char *const pairs[] = {"<=", ">=", "==", "!=", "&&", "||",
                                        "+=", "-=", "*=", "/=", "++", "--"};
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        if (strncmp(text, pairs[i], 2) == 0)
            return 2;
    }
    return 1;
}

/* Blanks or one comment; 0 where there is none, -1 for a comment without end. */
static long blank_length(const char *text)
{
    if (strncmp(text, "//", 2) == 0)
        return (long)strcspn(text, "\n");
    if (strncmp(text, "/*", 2) == 0) {
        const char *end = strstr(text + 2, "*/");
        return end ? (long)(end + 2 - text) : -1;
    }
    return (long)strspn(text, " \t\r\n");
}

bool form_tokens(const char *path, const char *text, int first_line, token **tokens, size_t *count)
{
    size_t capacity = 256;
    int line = first_line;
    *tokens = base_allocate(capacity * sizeof **tokens);
    *count = 0;
    for (;;) {
        token next = {.start = text, .line = line, .kind = TOKEN_END};
        long blank = blank_length(text);
        if (blank < 0) {
            base_error("%s:%d: expected */ to end this comment", path, line);
            return false;
        }
        if (blank > 0) {
            next.kind = TOKEN_BLANK;
            next.length = (size_t)blank;
        } else if (is_name_start(*text)) {
            next.kind = TOKEN_NAME;
            while (is_name(text[next.length]))
                next.length++;
        } else if (isdigit((unsigned char)*text) ||
                   (*text == '.' && isdigit((unsigned char)text[1]))) {
            next.kind = TOKEN_NUMBER;
            next.length = number_length(text);
        } else if (*text) {
            next.kind = TOKEN_SIGN;
            next.length = sign_length(text);
        }
        if (*count == capacity) {
            capacity *= 2;
            *tokens = base_reallocate(*tokens, capacity * sizeof **tokens);
        }
        (*tokens)[(*count)++] = next;
        if (next.kind == TOKEN_END)
            return true;
        for (size_t i = 0; i < next.length; i++)
            line += text[i] == '\n';
        text += next.length;
    }
}

bool token_is(const token *token, const char *text)
{
    return token->kind != TOKEN_BLANK && token->kind != TOKEN_END &&
           strlen(text) == token->length && memcmp(token->start, text, token->length) == 0;
}
