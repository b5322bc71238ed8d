// SPDX-License-Identifier: Apache-2.0
package dev.carom;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.function.BiConsumer;

/**
 * The library's classes a second time, read from the same class files, with other constants. What
 * they need besides is the platform's.
 */
final class PatchedClasses extends ClassLoader {

  private final BiConsumer<String, ConstantPool> patch;

  /**
   * Begins.
   *
   * @param patch changes the constants of a class, which is named
   */
  PatchedClasses(BiConsumer<String, ConstantPool> patch) {
    super(getPlatformClassLoader());
    this.patch = patch;
  }

  /** Not the parent first: it would find the module that is being tested. */
  @Override
  protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
    synchronized (getClassLoadingLock(name)) {
      Class<?> loaded = findLoadedClass(name);
      if (loaded != null) {
        return loaded;
      }
      return name.startsWith("dev.carom.") ? findClass(name) : super.loadClass(name, resolve);
    }
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    String file = "/" + name.replace('.', '/') + ".class";
    try (InputStream in = SweptCircle.class.getResourceAsStream(file)) {
      if (in == null) {
        throw new ClassNotFoundException(name);
      }
      ConstantPool pool = new ConstantPool(in.readAllBytes());
      patch.accept(name, pool);
      byte[] classFile = pool.classFile();
      return defineClass(name, classFile, 0, classFile.length);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
