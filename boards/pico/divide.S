/* What the compiler calls to divide: by the divider of the SIO, which takes eight cycles, instead of a loop. Quotient in
   r0, remainder in r1, as both kinds of call want them. The divider belongs to nobody, so interrupts wait meanwhile:
   handlers may divide too. A divisor of zero is the caller's mistake, as it is in C++. */

    .equ sio, 0xD0000000
    .equ div_udividend, 0x60
    .equ div_udivisor, 0x64
    .equ div_sdividend, 0x68
    .equ div_sdivisor, 0x6C
    .equ div_quotient, 0x70 /* to be read last: reading it ends the division */
    .equ div_remainder, 0x74

    .syntax unified
    .cpu cortex-m0plus
    .thumb

    .macro divide name, both, dividend, divisor
    .section .text.\name, "ax"
    .balign 4
    .global \name
    .global \both
    .thumb_func
\name:
    .thumb_func
\both:
    ldr r3, =sio
    mrs r2, primask
    cpsid i
    str r0, [r3, #\dividend]
    str r1, [r3, #\divisor]
    b 1f /* a branch takes two cycles: eight in all */
1:  b 2f
2:  b 3f
3:  b 4f
4:  ldr r1, [r3, #div_remainder]
    ldr r0, [r3, #div_quotient]
    msr primask, r2
    bx lr
    .ltorg
    .endm

    divide __aeabi_uidiv, __aeabi_uidivmod, div_udividend, div_udivisor
    divide __aeabi_idiv, __aeabi_idivmod, div_sdividend, div_sdivisor
