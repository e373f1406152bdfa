// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
package fallen.spy;

import fallen.fallen_persons_t;
import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import javax.swing.JFrame;
import javax.swing.Timer;
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
    return new AbstractAction("Fallen persons from above") {
      @Override
      public void actionPerformed(ActionEvent event) {
        show(channel);
      }
    };
  }

  /** Opens a window that follows the channel until it is closed. */
  static JFrame show(ChannelData channel) {
    PlanPanel plan = new PlanPanel();
    JFrame frame = new JFrame(channel.name);
    frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
    frame.add(plan);
    frame.pack();
    Timer timer = new Timer(REFRESH_MS, tick -> {
      if (!frame.isDisplayable()) ((Timer) tick.getSource()).stop();
      plan.show((fallen_persons_t) channel.last);
    });
    frame.setVisible(true);
    timer.start();
    return frame;
  }
}
