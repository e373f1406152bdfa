// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
package fallen.spy;

import fallen.fallen_person_t;
import fallen.fallen_persons_t;
import java.io.IOException;
import lcm.lcm.LCM;
import lcm.lcm.LCMDataInputStream;
import lcm.lcm.LCMSubscriber;

/** The shortest whole subscriber in Java: prints each fallen person. */
public class PersonListener implements LCMSubscriber {
  @Override
  public void messageReceived(LCM lcm, String channel, LCMDataInputStream bytes) {
    try {
      fallen_persons_t decision = new fallen_persons_t(bytes);
      for (fallen_person_t person : decision.hypotheses) {
        if (!person.is_person) continue;
        System.out.printf("%s frame %d: fallen person at (%.2f, %.2f) m, p %.3f%n", channel, decision.header.seq,
            person.centroid[0], person.centroid[1], person.probability);
      }
    } catch (IOException error) {
      System.err.println(channel + ": " + error.getMessage());
    }
  }

  /** @param arguments the LCM URL, if it is not the default */
  public static void main(String[] arguments) throws Exception {
    LCM lcm = arguments.length > 0 ? new LCM(arguments[0]) : LCM.getSingleton();
    lcm.subscribe("FALLEN_PERSONS_.*", new PersonListener());
    Thread.currentThread().join();
  }
}
