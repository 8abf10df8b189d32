/* The TECHNOL runtime as a library for controllers. docs/porting.md tells how to use it.
 *
 * One thread at a time may be in these functions, whatever the handle. A pointer must not be NULL unless it says so,
 * and points to as many bytes as the length beside it. Nothing here blocks or sleeps. Two things call you back:
 * technol_panicked, which you write, when nothing can go on; and the functions of technol_control.
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

/* ---- the control around the program ----------------------------------------------------------------------- */

/* Whatever a program asks for beyond computing, texts and copying: messages bound to bits, named inputs, tables, buses,
 * axes … comes to functions of yours. Without them such an instruction faults the PLC, with its name.
 *
 * They are called from technol_tick, in its task. They may not wait, and may not call anything of this header but the
 * technol_call functions, on the call that they are given and before they return. */

typedef struct technol_call technol_call;

/* When something is copied. */
typedef enum {
    TECHNOL_SLOW = 0,    /* each 20 ms, around the modules of the cycle */
    TECHNOL_FAST = 1,    /* each millisecond, around MODULE_FAST */
    TECHNOL_FASTEST = 2, /* each pass of MODULE_FASTEST */
} technol_rate;

typedef enum {
    TECHNOL_GO = 0,        /* what you move goes on */
    TECHNOL_STOP = 1,      /* STOP */
    TECHNOL_EMERGENCY = 2, /* emergency stop */
} technol_hold;

enum {
    TECHNOL_CARRIED_OUT = 0,
    TECHNOL_NOT_HERE = 1, /* you do not have the instruction: the PLC faults, and says so */
};

/* Each function may be NULL. */
typedef struct {
    void *context; /* handed to each */
    uint32_t (*service)(void *context, technol_call *call);
    /* Before and after the modules of a technol_rate; ports have been, and will be, copied besides. `memory` is that of
     * the PLC, to be used until the function returns. */
    void (*inputs)(void *context, uint32_t rate, uint64_t millis, uint8_t *memory, size_t len);
    void (*outputs)(void *context, uint32_t rate, uint64_t millis, uint8_t *memory, size_t len);
    /* The PLC starts: forget what the program declared. */
    void (*start)(void *context, bool cold);
    /* A stop, or the start after it (technol_hold), for whatever you move by yourself. */
    void (*hold)(void *context, uint32_t hold);
} technol_control;

/* Copies it; NULL takes it back. To be called while no PLC ticks. */
void technol_set_control(technol_plc *plc, const technol_control *control);

/* Which instruction: one of TECHNOL_CAN_SEND … below. */
uint32_t technol_call_service(const technol_call *call);

/* Number of this place in the program. An instruction that takes several cycles is called in each of them, and its
 * transfer is known by this number. */
uint32_t technol_call_place(const technol_call *call);

/* Milliseconds of PLC time. */
uint64_t technol_call_millis(const technol_call *call);

/* Operands, from 0 on, in the order of the language reference. False: left out, or of another kind. An index (BX) that
 * leads outside memory is false too, and faults the PLC when `service` returns.
 *
 * A number: a constant, a cell (with its sign), a bit (0 or 1). */
bool technol_call_integer(technol_call *call, size_t operand, int64_t *value);
bool technol_call_real(technol_call *call, size_t operand, double *value);

/* A text, or the word of a keyword in capitals: not ended by 0, and there until something is written. */
bool technol_call_text(technol_call *call, size_t operand, const uint8_t **text, size_t *len);

/* Where a cell or variable lies, and how many bytes may be used there. */
bool technol_call_area(technol_call *call, size_t operand, uint32_t *addr, uint32_t *len);

/* Memory of the PLC; nothing happens, and the PLC faults, when not all of it lies there. */
bool technol_call_read(technol_call *call, uint32_t addr, uint8_t *bytes, uint32_t len);
bool technol_call_write(technol_call *call, uint32_t addr, const uint8_t *bytes, size_t len);

/* Writes an integer to the cell or bit at an operand; other operands take nothing. A real with a fraction is written as
 * its 8 bytes, by technol_call_area and technol_call_write. */
bool technol_call_store(technol_call *call, size_t operand, int64_t value);

/* RLO and DR (64 bits), which most instructions answer with. */
bool technol_call_rlo(const technol_call *call);
void technol_call_set_rlo(technol_call *call, bool value);
int64_t technol_call_dr(const technol_call *call);
void technol_call_set_dr(technol_call *call, int64_t value);

/* The instructions, by technol_call_service. STRCPY to MEMCMP are carried out by the library itself. */
enum {
    TECHNOL_STRCPY = 0, TECHNOL_STRADD = 1, TECHNOL_BINSTR = 2, TECHNOL_BCDSTR = 3, TECHNOL_STRCMP = 4,
    TECHNOL_MEMCPY = 5, TECHNOL_MEMCMP = 6, TECHNOL_LDR_LIC = 7, TECHNOL_CAN_SEND = 8, TECHNOL_CAN_RECV = 9,
    TECHNOL_CAN_RECV_REQ = 10, TECHNOL_CAN_RECV_END = 11, TECHNOL_CAN_RECV_DEL = 12,
    TECHNOL_CAN_SYSIO_READ = 13, TECHNOL_CAN_SYSIO_WRITE = 14, TECHNOL_MAP_IN = 15, TECHNOL_MAP_OUT = 16,
    TECHNOL_MAP_AIN = 17, TECHNOL_MAP_AOUT = 18, TECHNOL_ANALOG_PORT = 19, TECHNOL_ANALOG = 20,
    TECHNOL_ANALOG_SPI = 21, TECHNOL_SPI_AX = 22, TECHNOL_AX_SPI = 23, TECHNOL_SPI_MAIN = 24,
    TECHNOL_RAMP = 25, TECHNOL_CAN_AX_SEND = 26, TECHNOL_EDEF = 27, TECHNOL_CNF_GET_INT = 28,
    TECHNOL_CNF_GET_REAL = 29, TECHNOL_CNF_GET_STR = 30, TECHNOL_CNF_GET_BIN = 31, TECHNOL_CNF_GET_BIT = 32,
    TECHNOL_CONST_GET = 33, TECHNOL_SHARE_VAR = 34, TECHNOL_SHARE_BIT = 35, TECHNOL_SA_READ = 36,
    TECHNOL_SA_WRITE = 37, TECHNOL_DEF_IN = 38, TECHNOL_DEF_OUT = 39, TECHNOL_UPDATE_IN = 40,
    TECHNOL_COM_SEND = 41, TECHNOL_COM_SEND_STR = 42, TECHNOL_COM_RECV = 43, TECHNOL_COM_CONTROL = 44,
    TECHNOL_PLCT_COL_INDEX = 45, TECHNOL_PLCT_COL_ID = 46, TECHNOL_PLCT_COL_TYPE = 47,
    TECHNOL_PLCT_GET_SELLINE = 48, TECHNOL_PLCT_SET_SELLINE = 49, TECHNOL_PLCT_CHANGED = 50,
    TECHNOL_PLCT_GET_LINESCOUNT = 51, TECHNOL_PLCT_GET_INT = 52, TECHNOL_PLCT_GET_REAL = 53,
    TECHNOL_PLCT_GET_STR = 54, TECHNOL_PLCT_GET_BIN = 55, TECHNOL_PLCT_SET_INT = 56,
    TECHNOL_PLCT_SET_REAL = 57, TECHNOL_PLCT_SET_STR = 58, TECHNOL_PLCT_SET_BIN = 59,
    TECHNOL_ECAT_COE_READ = 60, TECHNOL_ECAT_COE_WRITE = 61, TECHNOL_ECAT_SOE_READ = 62,
    TECHNOL_ECAT_SOE_WRITE = 63, TECHNOL_ECAT_COMMAND = 64, TECHNOL_POS_INIT = 65, TECHNOL_POS_INIT_X = 66,
    TECHNOL_POS_INIT_Y = 67, TECHNOL_POS_INIT_Z = 68, TECHNOL_POS_INIT_4 = 69, TECHNOL_POS_INIT_5 = 70,
    TECHNOL_POS_INIT_6 = 71, TECHNOL_POS_RESET = 72, TECHNOL_POS_RESET_X = 73, TECHNOL_POS_RESET_Y = 74,
    TECHNOL_POS_RESET_Z = 75, TECHNOL_POS_RESET_4 = 76, TECHNOL_POS_RESET_5 = 77, TECHNOL_POS_RESET_6 = 78,
    TECHNOL_POS_MODE = 79, TECHNOL_POS_MODE_X = 80, TECHNOL_POS_MODE_Y = 81, TECHNOL_POS_MODE_Z = 82,
    TECHNOL_POS_MODE_4 = 83, TECHNOL_POS_MODE_5 = 84, TECHNOL_POS_MODE_6 = 85, TECHNOL_POS_CONTROL = 86,
    TECHNOL_POS_CONTROL_X = 87, TECHNOL_POS_CONTROL_Y = 88, TECHNOL_POS_CONTROL_Z = 89,
    TECHNOL_POS_CONTROL_4 = 90, TECHNOL_POS_CONTROL_5 = 91, TECHNOL_POS_CONTROL_6 = 92, TECHNOL_REGUL_X = 93,
    TECHNOL_REGUL_Y = 94, TECHNOL_REGUL_Z = 95, TECHNOL_REGUL_4 = 96, TECHNOL_REGUL_5 = 97,
    TECHNOL_REGUL_6 = 98,
};

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

/* The same in words, cut to fit and ended by 0: what went wrong, and where. Empty without a fault. */
void technol_fault_text(const technol_plc *plc, char *text, size_t len);

/* ---- events ---------------------------------------------------------------------------------------------- */

typedef enum {
    TECHNOL_MESSAGE = 1,       /* number, sub_id, parameters, set */
    TECHNOL_OVERRUN = 2,
    TECHNOL_STATE_CHANGED = 3, /* number: technol_plc_state */
    TECHNOL_FAULT = 4,         /* see technol_faulted */
    TECHNOL_BLOCK_STARTED = 5,
    TECHNOL_BLOCK_FINISHED = 6,
    TECHNOL_BLOCK_ABORTED = 7,
    TECHNOL_BLOCK_REJECTED = 8, /* number: 0 not running, 1 too many wait, 2 out of range, 3 no feed */
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
