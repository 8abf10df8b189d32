/* Runs an image on recorded inputs and prints what it does, as an example and for the tests.
 *
 *     replay IMAGE TAPE
 *
 * A tape is a sequence of records: 'T' and 128 bytes of input ports make a tick; 'S' starts the PLC cold; 'B' starts
 * a block: the length of its list of M functions, the list, then t, s, h (int32, little endian; -1: none), motion_ms
 * (uint32), rapid (a byte), mode (a byte). 'A' annuls the block.
 *
 * For each tick one line: state, output ports (hexadecimal). Events go on lines of their own before it.
 */
#include "../include/technol.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

/* What a controller would have as an array in a section of its linker script. */
static uint8_t memory[4 << 20];

void technol_panicked(void) {
    fputs("the runtime cannot go on\n", stderr);
    abort();
}

static uint8_t *read_file(const char *path, size_t *len) {
    FILE *file = fopen(path, "rb");
    if (!file) {
        perror(path);
        exit(2);
    }
    size_t room = 1 << 20;
    uint8_t *bytes = malloc(room);
    *len = 0;
    for (;;) {
        *len += fread(bytes + *len, 1, room - *len, file);
        if (*len < room) {
            break;
        }
        room *= 2;
        bytes = realloc(bytes, room);
    }
    fclose(file);
    return bytes;
}

static uint32_t number(const uint8_t *bytes) {
    return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

/* A block from the tape; returns what follows it. */
static const uint8_t *block(technol_plc *plc, const uint8_t *at) {
    technol_block block = {0};
    block.m_len = *at++;
    block.m = at;
    at += block.m_len;
    block.t = (int32_t)number(at);
    block.s = (int32_t)number(at + 4);
    block.h = (int32_t)number(at + 8);
    block.motion_ms = number(at + 12);
    block.rapid = at[16];
    block.mode = at[17];
    technol_start_block(plc, &block);
    return at + 18;
}

static void print_events(technol_plc *plc) {
    technol_event event;
    while (technol_next_event(plc, &event)) {
        printf("event %" PRIu32 " %" PRIu32 " %" PRIu64 "\n", event.kind, event.number, event.cycle);
    }
}

int main(int argc, char **argv) {
    if (argc != 3) {
        fputs("replay IMAGE TAPE\n", stderr);
        return 2;
    }
    size_t image_len, tape_len;
    uint8_t *image = read_file(argv[1], &image_len);
    uint8_t *tape = read_file(argv[2], &tape_len);

    if (!technol_give_memory(memory, sizeof memory)) {
        fputs("the memory was not taken\n", stderr);
        return 1;
    }
    char message[200];
    technol_plc *plc = technol_load(image, image_len, message, sizeof message);
    if (!plc) {
        printf("refused: %s\n", message);
        return 1;
    }
    size_t loaded = technol_memory_used(), most = loaded;
    uint8_t outputs[TECHNOL_OUTPUTS] = {0};
    const uint8_t *at = tape, *end = tape + tape_len;
    while (at < end) {
        switch (*at++) {
        case 'S':
            technol_start(plc, true);
            break;
        case 'B':
            at = block(plc, at);
            break;
        case 'A':
            technol_abort_block(plc);
            break;
        case 'T':
            technol_tick(plc, at, outputs);
            at += TECHNOL_INPUTS;
            print_events(plc);
            printf("%" PRIu32 " ", technol_state(plc));
            for (int port = 0; port < TECHNOL_OUTPUTS; port++) {
                printf("%02x", outputs[port]);
            }
            putchar('\n');
            break;
        default:
            fputs("this is no tape\n", stderr);
            return 2;
        }
        size_t used = technol_memory_used();
        most = used > most ? used : most;
    }
    printf("hash %016" PRIx64 "\n", technol_state_hash(plc));
    technol_unload(plc);
    fprintf(stderr, "loaded %zu most %zu left %zu\n", loaded, most, technol_memory_used());
    return 0;
}
