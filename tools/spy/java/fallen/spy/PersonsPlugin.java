// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
package fallen.spy;

import fallen.fallen_persons_t;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;

/** For lcm-spy: a channel's decisions as a plan seen from above. lcm-spy finds it on the class path. */
public class PersonsPlugin implements SpyPlugin {
  private static final int REFRESH_MS = 100;

  @Override
  public boolean canHandle(long fingerprint) {
    return fingerprint == fallen_persons_t.LCM_FINGERPRINT;
  }

  @Override
  public Action getAction(JDesktopPane desktop, ChannelData channel) {
    return ChannelWindow.action("Fallen persons from above", channel, REFRESH_MS, PlanPanel::new,
        (panel, message) -> panel.show((fallen_persons_t) message));
  }
}
