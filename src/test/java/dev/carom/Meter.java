// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;

/**
 * The bytes that this thread has allocated. By reflection: the library's module, in which tests
 * run, reads java.base only.
 */
final class Meter {
  private final Object bean;
  private final Method allocated;

  Meter() throws ReflectiveOperationException {
    bean =
        Class.forName("java.lang.management.ManagementFactory")
            .getMethod("getThreadMXBean")
            .invoke(null);
    allocated =
        Class.forName("com.sun.management.ThreadMXBean")
            .getMethod("getCurrentThreadAllocatedBytes");
  }

  long bytes() throws IllegalAccessException, InvocationTargetException {
    return (Long) allocated.invoke(bean);
  }
}
