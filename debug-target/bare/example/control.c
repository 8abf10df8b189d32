/* A control around the program: a CAN bus, one named input and a licence, carried out by the host.
 *
 *     control IMAGE MILLISECONDS
 *
 * Prints what the program asks for and, at the end, how it stands. An example, and run by the tests.
 */
#include "../include/technol.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

static uint8_t memory[1 << 20];

void technol_panicked(void) {
    fputs("the runtime cannot go on\n", stderr);
    abort();
}

/* What this control knows. */
struct machine {
    bool licensed;
    int64_t delay;
    int stops;
};

/* CAN_SEND channel, packet: identifier (2 bytes), reserved, length, data. RLO is left alone, DR is 0 when it was sent. */
static uint32_t can_send(technol_call *call) {
    int64_t channel;
    uint32_t addr, len;
    uint8_t packet[12];
    if (!technol_call_integer(call, 0, &channel) || !technol_call_area(call, 1, &addr, &len)) {
        return TECHNOL_NOT_HERE;
    }
    /* The copy ends where the packet's variable does. */
    if (len > sizeof packet) {
        len = sizeof packet;
    }
    if (technol_call_read(call, addr, packet, len)) {
        printf("%" PRIu64 " ms: CAN %" PRId64 " sends", technol_call_millis(call), channel);
        for (uint32_t at = 0; at < len; at++) {
            printf(" %02x", packet[at]);
        }
        putchar('\n');
        technol_call_set_dr(call, 0);
    }
    return TECHNOL_CARRIED_OUT;
}

/* CNF_GET_INT cell, 'name': RLO tells whether there is such a parameter. */
static uint32_t parameter(const struct machine *machine, technol_call *call) {
    const uint8_t *name;
    size_t len;
    bool known = technol_call_text(call, 1, &name, &len) && len == 5 && name[0] == 'D';
    if (known) {
        technol_call_store(call, 0, machine->delay);
    }
    technol_call_set_rlo(call, known);
    return TECHNOL_CARRIED_OUT;
}

static uint32_t service(void *context, technol_call *call) {
    const struct machine *machine = context;
    switch (technol_call_service(call)) {
    case TECHNOL_CAN_SEND:
        return can_send(call);
    case TECHNOL_CNF_GET_INT:
        return parameter(machine, call);
    case TECHNOL_LDR_LIC:
        technol_call_set_rlo(call, machine->licensed);
        return TECHNOL_CARRIED_OUT;
    default:
        return TECHNOL_NOT_HERE;
    }
}

static void start(void *context, bool cold) {
    (void)context;
    printf("started %s\n", cold ? "cold" : "warm");
}

static void hold(void *context, uint32_t how) {
    struct machine *machine = context;
    machine->stops += how != TECHNOL_GO;
}

int main(int argc, char **argv) {
    static uint8_t image[1 << 20];
    if (argc != 3) {
        fputs("control IMAGE MILLISECONDS\n", stderr);
        return 2;
    }
    FILE *file = fopen(argv[1], "rb");
    if (!file) {
        perror(argv[1]);
        return 2;
    }
    size_t len = fread(image, 1, sizeof image, file);
    fclose(file);

    char text[200];
    technol_give_memory(memory, sizeof memory);
    technol_plc *plc = technol_load(image, len, text, sizeof text);
    if (!plc) {
        printf("refused: %s\n", text);
        return 1;
    }
    struct machine machine = {.licensed = true, .delay = 7, .stops = 0};
    technol_control control = {.context = &machine, .service = service, .start = start, .hold = hold};
    technol_set_control(plc, &control);
    technol_start(plc, true);
    uint8_t inputs[TECHNOL_INPUTS] = {0}, outputs[TECHNOL_OUTPUTS];
    for (long left = atol(argv[2]); left > 0; left--) {
        technol_tick(plc, inputs, outputs);
    }
    printf("P0OUT %02x, P1OUT %02x, %d stops\n", outputs[0], outputs[1], machine.stops);
    technol_fault_text(plc, text, sizeof text);
    printf("fault: %s\n", *text ? text : "none");
    technol_unload(plc);
    return 0;
}
