/* The TECHNOL runtime as a library for controllers. docs/porting.md tells how to use it.
 *
 * One thread at a time may be in these functions, whatever the handle. A pointer must not be NULL unless it says so,
 * and points to as many bytes as the length beside it. Nothing here blocks, sleeps or calls back, except that
 * technol_panicked, which you write, is called when nothing can go on.
 */
#ifndef TECHNOL_H
#define TECHNOL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    TECHNOL_INPUTS = 128, /* input ports: P1IN to P128IN */
    TECHNOL_OUTPUTS = 96, /* output ports: P0OUT to P95OUT */
};

/* ---- what you provide ------------------------------------------------------------------------------------ */

/* Memory ran out while loading, or the library made a mistake. Bring the machine to a safe state; do not return. */
#if defined(__GNUC__)
__attribute__((noreturn))
#endif
void technol_panicked(void);

/* ---- memory ---------------------------------------------------------------------------------------------- */

/* First call of all: gives the library its memory, once. False: given already, NULL, or under 1 KiB. */
bool technol_give_memory(uint8_t *memory, size_t len);

/* Bytes of it in use. Does not change in technol_tick, except that a block's list of M functions is given back. */
size_t technol_memory_used(void);

/* ---- a program ------------------------------------------------------------------------------------------- */

typedef struct technol_plc technol_plc;

/* Loads an image file (as `technol build` writes it) or a program as it is downloaded; the bytes are not needed
 * afterwards. NULL: it was refused, and `message` (may be NULL) says why, cut to fit and ended by 0. */
technol_plc *technol_load(const uint8_t *image, size_t len, char *message, size_t message_len);

/* Gives its memory back. NULL is fine. */
void technol_unload(technol_plc *plc);

/* Ports that are copied each millisecond around MODULE_FAST, by index: 0 is P1IN and P0OUT. A list may be NULL when
 * it is empty. False: there is no such port, and nothing is changed. */
bool technol_set_fast_ports(technol_plc *plc, const uint8_t *inputs, size_t inputs_len,
                            const uint8_t *outputs, size_t outputs_len);

/* ---- commands: obeyed by the next tick, in order --------------------------------------------------------- */

/* Starts the PLC: that tick executes MODULE_INIT and takes no PLC time. Cold: data as at power-on. */
void technol_start(technol_plc *plc, bool cold);

/* Stops it through MODULE_DONE; a second one does not wait for MODULE_DONE_FINISHED. */
void technol_stop(technol_plc *plc, bool power_off);

/* Fatal error of the control: MODULE_HALT, then halted. */
void technol_halt(technol_plc *plc);

typedef enum {
    TECHNOL_AUTO = 0,
    TECHNOL_CENTRAL_ANNULMENT = 1,
    TECHNOL_REFERENCE = 2,
    TECHNOL_OTHER_MODE = 3,
} technol_block_mode;

/* A part-program block. */
typedef struct {
    const uint8_t *m; /* M functions, 0 to 99; may be NULL when there are none */
    size_t m_len;
    int64_t t;          /* tool, at most eight digits; negative: none */
    int32_t s;          /* spindle value, 0 to 32767; negative: none */
    int32_t h;          /* H function, 0 to 99; negative: none */
    uint32_t motion_ms; /* how long its movement takes */
    bool rapid;
    uint8_t mode; /* technol_block_mode */
} technol_block;

/* At most 16 wait; one more, or one out of range, is answered by TECHNOL_BLOCK_REJECTED. */
void technol_start_block(technol_plc *plc, const technol_block *block);

/* Start after a stop. */
void technol_continue_block(technol_plc *plc);

/* Central annulment: breaks the block and forgets those that wait. */
void technol_abort_block(technol_plc *plc);

/* ---- time ------------------------------------------------------------------------------------------------ */

/* One millisecond of the PLC, from the inputs to the outputs. Each 20th does the work of a whole cycle. */
void technol_tick(technol_plc *plc, const uint8_t inputs[TECHNOL_INPUTS], uint8_t outputs[TECHNOL_OUTPUTS]);

/* ---- state ----------------------------------------------------------------------------------------------- */

typedef enum {
    TECHNOL_STOPPED = 0,
    TECHNOL_STARTING = 1, /* running; a file has not executed MODULE_INIT_FINISHED yet */
    TECHNOL_RUNNING = 2,
    TECHNOL_STOPPING = 3,
    TECHNOL_HALTED = 4,
    TECHNOL_FAULTED = 5, /* outputs are off */
} technol_plc_state;

uint32_t technol_state(const technol_plc *plc); /* technol_plc_state */

/* Milliseconds since the start of the PLC. */
uint64_t technol_millis(const technol_plc *plc);

/* Two PLCs with the same program that are in the same state give the same number. */
uint64_t technol_state_hash(const technol_plc *plc);

typedef struct {
    uint64_t cycle;   /* of 20 ms */
    uint32_t pc;      /* operation; the debug information of the image knows its file and line */
    uint8_t file;     /* of the module, 0-based in the order of execution */
    uint8_t module;   /* kind of module, numbered as in the debug protocol */
    int32_t sequence; /* mechanism; -1: outside of them */
} technol_fault;

/* Whether a fault stopped the PLC, and where. */
bool technol_faulted(const technol_plc *plc, technol_fault *fault);

/* ---- events ---------------------------------------------------------------------------------------------- */

typedef enum {
    TECHNOL_MESSAGE = 1,       /* number, sub_id, parameters, set */
    TECHNOL_OVERRUN = 2,
    TECHNOL_STATE_CHANGED = 3, /* number: technol_plc_state */
    TECHNOL_FAULT = 4,         /* see technol_faulted */
    TECHNOL_BLOCK_STARTED = 5,
    TECHNOL_BLOCK_FINISHED = 6,
    TECHNOL_BLOCK_ABORTED = 7,
    TECHNOL_BLOCK_REJECTED = 8, /* number: 0 not running, 1 too many wait, 2 out of range */
} technol_event_kind;

typedef struct {
    uint32_t kind; /* technol_event_kind */
    uint32_t number;
    uint64_t cycle; /* of 20 ms; 0 where none belongs to it */
    int64_t sub_id;
    int64_t parameters[3];
    uint8_t present; /* bit 0: sub_id is there; bits 1 to 3: the parameters are */
    uint8_t set;     /* a message is shown (1) or removed (0) */
} technol_event;

/* The event that has waited longest; false: there is none. 64 are kept. */
bool technol_next_event(technol_plc *plc, technol_event *event);

/* Events lost since the last call because nobody fetched them. */
uint32_t technol_lost_events(technol_plc *plc);

/* ---- memory of the PLC ----------------------------------------------------------------------------------- */

/* Both are false, and do nothing, when not all of it lies in the memory of the PLC. */
bool technol_read(const technol_plc *plc, uint32_t addr, uint8_t *bytes, size_t len);
bool technol_write(technol_plc *plc, uint32_t addr, const uint8_t *bytes, size_t len);

#ifdef __cplusplus
}
#endif

#endif
